#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lang/syntax/ast.h"
#include "lang/syntax/lexer.h"
#include "lang/syntax/outline.h"
#include "lang/syntax/parser.h"
#include "lang/syntax/token.h"
#include "lang/text/diagnostic.h"

/// Private to the parser: recursive descent, one function a grammar rule, the rule above it.
///
/// Where a rule cannot go on it reports and throws SyntaxError; the statement loop catches it and
/// goes on behind the statement (recover()). Rules whose block must be read all the same catch it
/// earlier. GiveUp ends the parsing of a text that is hopeless.
namespace rob::lang {

/// Whether a line can go on with this token inside brackets: a reserved word that is neither
/// operator nor value ends the statement, so that a bracket left open costs one line.
bool begins_statement(const Token& token);

/// A token for messages: 'MOVE', "the end of the line".
std::string described(const Token& token);

/// BOOL, LENGTH, …, in any case; empty if this version has no such type.
std::optional<Type> named_type(std::string_view word);

/// "IF": what is closed by ENDIF.
std::string_view opener_of(Keyword closer);

/// Whether a value goes on with this sign.
bool goes_on(const Token& token);

/// A clause of the language, whether this version has it or not; empty if it is none.
std::string_view clause_word(const Token& token);

/// A file that a text USEs, read already.
struct Import {
  std::string name;        ///< as USE writes it
  std::uint32_t line = 0;  ///< of the USE
  std::uint32_t file = 0;
  Program* program = nullptr;
};

/// What a text is part of.
struct SourceContext {
  std::uint32_t file = 0;
  TextParts parts{};                 ///< of the text
  const Outline* outline = nullptr;  ///< of the text
  std::vector<Import> imports{};
  std::size_t nodes = 0;          ///< of the files that were read before
  std::size_t names = 0;          ///< the same
  std::size_t array_lengths = 0;  ///< the same
  /// Of all of them.
  std::shared_ptr<TypeTable> types = std::make_shared<TypeTable>();
};

class Parser {
 public:
  Parser(std::string_view source, Diagnostics& diagnostics, SourceContext context);
  Program program();
  /// That were declared so far, those of the files before included.
  std::size_t names() const { return names_; }
  Block line_at(std::size_t offset, const Place& place);

 private:
  struct SyntaxError {};
  struct GiveUp {};

  /// A block that is being read, and the word that closes it.
  struct OpenBlock {
    Keyword opener;
    Keyword closer;
    Place place;
  };

  // Tokens (parser.cpp)
  void shift();
  void advance();
  bool at(TokenKind kind) const { return current_.kind == kind; }
  bool at(Keyword keyword) const;
  bool at_word(std::string_view word) const;
  bool accept(TokenKind kind);
  bool at_line_end() const;
  bool at_new_statement() const;
  bool line_ends_with(Keyword keyword) const;
  Place behind_previous() const;

  // Errors (parser.cpp)
  void report(std::string_view code, const Place& place, std::string message,
              std::string help = "");
  [[noreturn]] void fail(std::string_view code, const Place& place, std::string message,
                         std::string help = "");
  [[noreturn]] void fail_here(std::string_view code, std::string message, std::string help = "");
  void recover();
  void recover_until(Keyword keyword);
  std::string remedy() const;

  // Statements (parse_statements.cpp)
  void statement(Block& block);
  void any_statement(Block& block);
  bool block_statement(Block& block);
  void simple(Block& block);
  void word_statement(Block& block);
  void unknown_word(Block& block);
  std::string_view statement_meant() const;
  void assignment(Block& block);
  void print(Block& block);
  void wait(Block& block);
  void alternative(Block& block);
  void end_of_line();
  void add(Block& block, const Place& place, decltype(Statement::node) node);

  // Declarations (parse_declarations.cpp)
  void declaration(Block& block);
  void signal_declaration(Block& block);
  void pulse(Block& block);
  void scale(SignalDeclaration& signal);
  Name channel(std::string_view behind);
  bool at_channel() const;
  void declared_names(Declaration& declaration);
  void declared_type_and_value(Declaration& declaration);
  // Frames (parse_frames.cpp)
  void frame_declaration(Block& block);

  // HALT and ASK (parse_operator.cpp)
  void halt_statement(Block& block);
  void ask_statement(Block& block);
  bool operators_simulation(Simulate& node);

  // USE (parse_use.cpp)
  void use_statement(Block& block);
  const Import* import_named(std::string_view name) const;
  bool at_foreign_name() const;
  std::string foreign_name();
  const TypeDetail* imported_type(std::string_view name, const Place& place,
                                  const TypeTable::Named& types);

  // Points (parse_points.cpp)
  void point_declaration(Block& block);
  void teach_statement(Block& block);
  void zero_statement(Block& block);

  Type pose_type();
  Declaration::Declared declared_name(std::string_view kind);
  void count_name();
  Type type();
  Type vec_type();
  Type unit_type();

  // ARRAY, RECORD and lists (parse_compounds.cpp)
  ExprPtr list();
  Type array_type();
  void record_declaration(Block& block);
  void record_fields(RecordDeclaration& record);
  RecordDeclaration::Fields record_group();

  // Motions (parse_motion.cpp)
  bool at_motion() const;
  void move(Block& block);
  bool plain_motion(Block& block);
  void target_of(Move& move);
  bool at_name_of_value() const;
  bool at_clause_word(std::string_view word) const;
  void joint_target(Move& move);
  void curve(Move& move);
  void spiral(Move& move);
  void jog(Move& move);
  void expect_word(std::string_view word, std::string_view behind, std::string_view example);
  ExprPtr target(std::string_view motion, bool in_list = false);
  bool group_goes_on() const;
  bool at_value() const;
  bool at_list() const;
  [[noreturn]] void fail_target(std::string_view motion);
  void clauses(Clauses& clauses);
  void report_twice(std::string_view word);
  void profile(Clauses& clauses);
  void clause(Clauses& clauses, Clause which, std::string_view word);
  bool at_live() const;
  bool at_further_value() const;
  [[noreturn]] void fail_clause();

  // WITH, IN, PATH, PRESS, OVERRIDE, LOAD (parse_surroundings.cpp)
  bool at_placed_word(std::string_view word);
  bool in_path() const;
  void with_tool(Surroundings& surroundings);
  void in_frame(Surroundings& surroundings);
  ExprPtr name_behind(std::string_view word, std::string_view example);
  void with_statement(Block& block);
  void path_statement(Block& block);
  void press_statement(Block& block);
  void press_header(Press& press);
  void override_statement(Block& block);
  void load_statement(Block& block);
  template <typename Header>
  void header_up_to_do(Header header);

  // What is looked at in every control cycle (parse_watching.cpp)
  void behind_motion(Block& block, bool may_open_block);
  void when_statement(Block& block);
  static bool stops_for(const Block& action);
  void add_handler(const Place& place, const Place& end);
  void path_events(WatchedMotion& motion, const Place& place);
  WayPoint path_event();
  void action(Block& block, std::string_view behind);

  // Blocks (parse_blocks.cpp)
  Block block_of(const OpenBlock& open);
  bool at_block_end() const;
  void close(const OpenBlock& open);
  void close_with_end(const OpenBlock& open);
  void report_unclosed(const OpenBlock& open);
  bool closes_outer() const;
  [[noreturn]] void stray_closer();
  void if_statement(Block& block);
  void behind_then(Block& body);
  void further_branches(If& node, const OpenBlock& open);
  void while_statement(Block& block);
  void for_statement(Block& block);
  void for_header(For& loop);

  // Loops without condition, SELECT, ASSERT (parse_flow.cpp)
  void loop_statement(Block& block);
  void select_statement(Block& block);
  void select_branches(Select& node, const OpenBlock& open);
  void case_values(Select::Case& branch);
  void assert_statement(Block& block);
  std::string source_text(std::size_t begin, std::size_t end) const;
  void header_end(std::string_view word);
  void skip_header();
  ExprPtr condition(Keyword last);
  void header_word(Keyword word, std::string_view behind);

  // ROBOT, UNITS, LAW (parse_header.cpp)
  void header(const Block& block);
  void robot_header(const Place& place);
  void law_header(const Place& place);
  void units_header();

  // TRY and RAISE (parse_errors.cpp)
  void try_statement(Block& block);
  void rescue_header(Try& node);
  void raise_statement(Block& block);

  // What later versions have (parse_later.cpp)
  void declare_unknown(Block& block);
  void skip_later_block(std::string_view opener, std::string_view closer);
  bool skip_line();

  // TASK and START (parse_tasks.cpp)
  void task();
  void start_statement(Block& block);

  // TEST (parse_tests.cpp)
  void test();
  void expect_statement(Block& block);
  void simulate_statement(Block& block);

  // PROC, FUNC and calls (parse_routines.cpp)
  void routine();
  void routine_header(Routine& routine);
  Routine::Parameters parameters();
  /// What is defined anywhere in the text.
  struct DefinedNames {
    std::set<std::string> routines;
    std::set<std::string> records;
  };
  const DefinedNames& defined_names();
  bool names_routine(std::string_view name);
  bool names_record(std::string_view name);
  void call_statement(Block& block);
  void return_statement(Block& block);

  // Expressions (parse_expressions.cpp)
  ExprPtr expression();
  ExprPtr conjunction();
  ExprPtr inversion();
  ExprPtr relation();
  ExprPtr sum();
  ExprPtr term();
  ExprPtr unary();
  bool at_least_int() const;
  ExprPtr power();
  ExprPtr postfix();
  static std::string callee_of(const Expr& expr);
  ExprPtr member(ExprPtr object);
  ExprPtr index(ExprPtr object);
  ExprPtr primary();
  ExprPtr literal(decltype(Expr::node) node);
  ExprPtr parenthesized();
  ExprPtr tuple(const Place& place, Tuple elements);
  Tuple elements(std::string_view what);
  Tuple::Element element();
  ExprPtr call(const Place& place, std::string callee);
  void close_bracket(std::string_view what);
  [[noreturn]] void fail_value();
  ExprPtr binary(BinaryOp op, const Place& place, ExprPtr left, ExprPtr right);
  ExprPtr make(const Place& place, decltype(Expr::node) node, int height = 1);
  void count_node(const Place& place);

  /// Bounds the recursion of the parser: one level a bracket, sign or block.
  class Level {
   public:
    explicit Level(Parser& parser);
    ~Level() { --parser_.level_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Parser& parser_;
  };
  [[noreturn]] void fail_too_deep(const Place& place);

  std::string_view source_;
  Diagnostics& diagnostics_;
  Lexer lexer_;
  const Outline& outline_;
  std::vector<Import> imports_;
  Token previous_;
  Token current_;
  Token next_;
  int brackets_ = 0;  ///< open ones; inside them line ends do not count
  int level_ = 0;
  bool rereading_ = false;  ///< what the checker has refused: as a tree
  std::size_t nodes_;
  std::size_t names_;
  std::uint32_t muted_line_ = 0;  ///< has had its message
  std::vector<OpenBlock> open_blocks_;
  Header header_;
  std::uint32_t file_;
  std::size_t first_array_length_;
  std::shared_ptr<TypeTable> types_;
  std::vector<Program::ArrayLength> array_lengths_;
  std::vector<Program::FrameUse> frame_uses_;
  std::set<std::string> taught_;
  bool surroundings_ = false;
  std::vector<Routine> routines_;
  std::optional<DefinedNames> defined_names_;  ///< once asked for
};

}  // namespace rob::lang
