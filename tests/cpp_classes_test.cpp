// How classes are read (tests/support/cpp_classes.h), on texts that are counted by hand.

#include "tests/support/cpp_classes.h"

#include <doctest/doctest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/support/source_files.h"

using rob::test::classes_in;
using rob::test::CppClass;
using rob::test::tokens_of;

namespace {

std::string no_file(const std::string& name) { throw std::runtime_error("who reads " + name); }

/// "Name methods members" of each class, in their order.
std::string counted(std::string_view text, const rob::test::ReadIncluded& read = no_file) {
  std::string all;
  for (const CppClass& one : classes_in(tokens_of(text, read))) {
    if (!all.empty()) all += ", ";
    all += one.name + " " + std::to_string(one.methods.size()) + " " +
           std::to_string(one.members.size());
  }
  return all;
}

}  // namespace

TEST_CASE("functions are methods, overloads too, and each declarator is a member") {
  CHECK(counted("struct A {};") == "A 0 0");
  CHECK(counted("class A { void f(); void f(int); int g() const { return 1; } int x; };") ==
        "A 3 1");
  CHECK(counted("struct A { int a, b; double c[3], *d; int e : 3, f : 5; };") == "A 0 6");
  CHECK(counted("struct A { static void f(); virtual int g() = 0; auto h() -> int; };") == "A 3 0");
}

TEST_CASE("constructors and operators count, what is defaulted or deleted does not") {
  CHECK(counted(R"(class A {
   public:
    A();
    explicit A(int x) : x_(x), y_{x, {1}}, z_([](int i) { return i; }(2)) { start(); }
    A(const A&) = delete;
    A& operator=(const A&) = default;
    ~A();
    bool operator==(const A&) const = default;
    bool operator<(const A& o) const { return x_ < o.x_; }
    int operator()(int) const;
    explicit operator bool() const;
    operator std::map<int, void()>() const noexcept(sizeof(int) < 8);
    double operator[](int i) const;
    void* operator new(std::size_t);
   private:
    int x_;
    Y y_, z_;
  };)") == "A 9 3");
}

TEST_CASE("friends, aliases, enums, forward declarations and static values do not count") {
  CHECK(counted(R"(class A {
    friend class B;
    friend bool operator==(const A& a, const A& b) { return a.x == b.x; }
    friend void swap(A&, A&);
    using T = std::map<int, int>;
    using Base::Base;
    typedef int (*F)(int);
    static_assert(sizeof(int) == 4, "no; yes { ");
    enum class K : unsigned char { One, Two = f(2) };
    enum { kThree };
    class B;
    struct C;
    static constexpr int kA = 1, kB = 2;
    static inline std::vector<int> all{1, 2};
    inline static const char* name = "x";
    int x = 0;
  };)") == "A 0 1");
}

TEST_CASE("a member's own value does not mislead the count") {
  CHECK(counted(R"(struct A {
    std::map<int, std::pair<A, B>> a{{1, {2, 3}}}, b;
    std::function<int(int, int)> c = [](int x, int y) { int z = x; return z < y ? z : y; };
    std::array<int, (3 > 2)> d = {1, 2}, e;
    bool f = 1 < 2, g = true;
    int h = std::max<int>(1, 2), i = p<q, r>::value, j;
    std::atomic<int> k{0}, l{g<1>()};
    alignas(64) std::atomic<std::size_t> m{0};
    decltype(f(1)) n;
    [[maybe_unused]] int o;
    mutable const int& p;
    unsigned long long q = 1'000'000, r = '\'' + ';';
    std::string s = "a; int b; \"", t = R"x(}; " void f(); )x";
  };)") == "A 0 20");
}

TEST_CASE("pointers to functions are values") {
  CHECK(counted(R"(class A {
    void (*a)(int, int) = nullptr;
    int (B::*b)(int) const;
    int (&c)[3];
    Reply (std::vector<int>::*d)();
    int (f)(int);
  };)") == "A 1 4");
}

TEST_CASE("comments and texts hold no code") {
  CHECK(counted("struct A {  // struct B { int x; };\n /* int y; { */ int z; };") == "A 0 1");
  CHECK(counted("const char* a = \"struct A { int x; };\"; char c = '{';") == "");
  CHECK(counted("auto a = R\"(struct A { \" b)\"; struct B { int x; };") == "B 0 1");
  CHECK(counted("auto a = uR\"--(struct A { )-\")--\"; struct B { int x; };") == "B 0 1");
  CHECK(counted("#define A struct B { \\\n int x; // more \\\n int y; \n struct C { int x; };") ==
        "C 0 1");
}

TEST_CASE("a class within a class counts on its own") {
  CHECK(counted(R"(class A {
    struct B { int x, y; void f(); };
    struct C { class D { int x; }; D d; } c, e;
    B b;
    enum K { One } k;
    struct B* next;
  };)") == "A 0 5, A::B 1 2, A::C 0 1, A::C::D 0 1");
  CHECK(counted("struct A::B : C<int, {1}>, private D { int x; };") == "A::B 0 1");
}

TEST_CASE("what an unnamed union holds belongs to the class around it") {
  CHECK(counted("struct A { union { int a; double b; }; struct { int c; } d; };") ==
        "A 0 3, A::(unnamed) 0 2, A::(unnamed) 0 1");
}

TEST_CASE("classes are found wherever they stand") {
  CHECK(counted("namespace a { namespace { struct A { int x; }; } }") == "A 0 1");
  CHECK(counted("void f() { struct A { int x; void g() { struct B {}; } }; A a; }") ==
        "A 1 1, A::B 0 0");
  CHECK(counted("auto f = [] { class A final : public B { int x; }; };") == "A 0 1");
  CHECK(counted("struct [[nodiscard]] A {}; struct alignas(8) B {};") == "A 0 0, B 0 0");
  CHECK(counted("struct A a; class B; enum class C { x }; enum struct D : int { y };") == "");
  CHECK(counted("struct A f(struct B b) { for (struct A a : b) g(a); }") == "");
}

TEST_CASE("templates are classes and methods as all others") {
  CHECK(counted(R"(
    template <class T, template <class> class U, typename = std::enable_if_t<(1 > 2)>>
    class A : public B<T, (1 > 2)> {
      template <class V> requires std::integral<V> && (sizeof(V) < 8)
      void f(V v) { v < 1 ? g() : h(); }
      template <typename... W> A(W... w) requires requires(T t) { t.x; } : B<T>(w...), c{w...} {}
      template <class X> struct C { X x; };
      template <class Y> static constexpr int kD = 1;
      T t;
    };
    template <> struct A<int, (2 > 1)> { int x, y; };)") == "A 2 1, A::C 0 1, A<int,(2>1)> 0 2");
}

TEST_CASE("macros and included pieces bring their declarations") {
  CHECK(counted("#define ROB_PAIR(name, value) int name##_ = value, b; void name();\n"
                "struct A { ROB_PAIR(x, f(1, 2)) ROB_PAIR(y, z) };") == "A 2 4");
  const auto read = [](const std::string& name) -> std::string {
    if (name == "a.def") return "ROB_F(one, \"1, 2\")\nROB_F(two, \")\")\n#undef ROB_F\n";
    if (name == "b.inc") return "void three();\nint four;\n#include \"c.inc\"\n";
    if (name == "c.inc") return "struct B { int x; };";
    return no_file(name);
  };
  CHECK(counted("#include <vector>\n#include \"a.h\"\nstruct A {\n"
                "#define ROB_F(name, text) void name(); const char* name##_text = #text;\n"
                "#include \"a.def\"\n#include \"b.inc\"\n int ROB_F; };",
                read) == "A 3 4, A::B 0 1");
  CHECK(counted("#if X\nstruct A { int x; };\n#else\nstruct A { int x, y; };\n#endif") ==
        "A 0 1, A 0 2");
}

TEST_CASE("methods and members are known by their names") {
  const auto classes = classes_in(tokens_of(R"(class A {
    static void f(int x = g(1));
    A() : a(1), b{2} {}
    bool operator<(A) const;
    int a, *b = nullptr;
    const std::map<int, std::string> c[2];
    void (*d)(int), (*e)(int);
    mutable struct { int f; } g : 3;
    int h(), i() const;
  };)",
                                            no_file));
  REQUIRE(!classes.empty());
  std::string all;
  for (const rob::test::CppMethod& one : classes[0].methods) all += one.name + " ";
  CHECK(all == "f A operator h i ");
  all.clear();
  for (const rob::test::CppMember& one : classes[0].members) all += one.name + " ";
  CHECK(all == "a b c d e g ");
  CHECK(classes[0].members[2].type == "const std::map<int,std::string>");
}

TEST_CASE("the tokens of a method reach from its parameters to its end") {
  const auto tokens =
      tokens_of("struct A { int f(int x) const { return x; } void g(); };", no_file);
  const auto methods = classes_in(tokens).at(0).methods;
  REQUIRE(methods.size() == 2);
  CHECK(tokens[methods[0].begin].is("("));
  CHECK(tokens[methods[0].end - 1].is("}"));
  CHECK(tokens[methods[0].end].is("void"));
  CHECK(tokens[methods[1].end - 1].is(";"));
}

TEST_CASE("a text with an open bracket or quote is refused") {
  CHECK_THROWS_AS(counted("struct A { void f( };"), std::runtime_error);
  CHECK_THROWS_AS(counted("struct A {"), std::runtime_error);
  CHECK_THROWS_AS(counted("struct A { char* x = \"; };\n"), std::runtime_error);
  CHECK_THROWS_AS(counted("/* struct A {"), std::runtime_error);
}
