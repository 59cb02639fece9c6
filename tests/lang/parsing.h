#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/syntax/parser.h"

/// What the parser's tests share: a text is parsed, its tree and its messages are looked at.
namespace rob::lang {

struct Parsed {
  Program program;
  Diagnostics diagnostics;

  template <typename Node>
  const Node& statement(std::size_t index = 0) const {
    REQUIRE(index < program.statements.size());
    const Node* node = std::get_if<Node>(&program.statements[index].node);
    REQUIRE(node != nullptr);
    return *node;
  }
};

inline Parsed parsed(std::string_view source) {
  Parsed result;
  result.program = parse(source, result.diagnostics);
  return result;
}

inline Parsed sound(std::string_view source) {
  Parsed result = parsed(source);
  for (const Diagnostic& diagnostic : result.diagnostics.all()) {
    FAIL_CHECK(render(diagnostic, "test", source));
  }
  return result;
}

/// An expression with all its brackets, to see how it was read.
inline std::string shown(const ExprPtr& expr) {
  if (!expr) return "_";
  struct Show {
    std::string operator()(const NumberLiteral& n) const {
      return n.is_integer ? std::to_string(n.integer) : "real";
    }
    std::string operator()(const BoolLiteral& b) const { return b.value ? "TRUE" : "FALSE"; }
    std::string operator()(const StringLiteral& s) const { return "\"" + s.value + "\""; }
    std::string operator()(const Name& n) const { return n.text; }
    std::string operator()(const Unary& u) const {
      constexpr const char* kSigns[] = {"-", "+", "NOT ", "BITNOT "};
      return "(" + std::string(kSigns[static_cast<int>(u.op)]) + shown(u.operand) + ")";
    }
    static std::string sign(BinaryOp op) {
      constexpr const char* kSigns[] = {
          "OR", "XOR", "AND", "==",  "<>", "<",      "<=",    ">",      ">=",  "+",  "-",
          "*",  "/",   "DIV", "MOD", "^",  "BITAND", "BITOR", "BITXOR", "SHL", "SHR"};
      return std::string(" ") + kSigns[static_cast<int>(op)] + " ";
    }
    std::string operator()(const Binary& b) const {
      return "(" + shown(b.left) + sign(b.op) + shown(b.right) + ")";
    }
    std::string operator()(const Chain& c) const {
      std::string text = "{" + shown(c.first);
      for (const Chain::Step& step : c.steps) text += sign(step.op) + shown(step.term);
      return text + "}";
    }
    std::string operator()(const Call& c) const {
      std::string text = c.callee + "(";
      for (const ExprPtr& argument : c.arguments) text += shown(argument) + ";";
      return text + ")";
    }
    std::string operator()(const Tuple& t) const {
      std::string text = "<";
      for (const Tuple::Element& element : t.elements) {
        text += element.name + (element.name.empty() ? "" : ":") + shown(element.value) + ";";
      }
      return text + ">";
    }
    std::string operator()(const List& l) const {
      std::string text = "[";
      for (const ExprPtr& element : l.elements) text += shown(element) + ";";
      return text + "]";
    }
    std::string operator()(const Member& m) const { return shown(m.object) + "." + m.field; }
    std::string operator()(const Index& i) const {
      return shown(i.object) + "[" + shown(i.index) + "]";
    }
  };
  return std::visit(Show{}, expr->node);
}

inline std::string expression(const std::string& text) {
  return shown(sound("v = " + text).statement<Assign>().value);
}

/// "line:column code message" of every error.
inline std::vector<std::string> errors(std::string_view source) {
  std::vector<std::string> result;
  const Parsed p = parsed(source);
  for (const Diagnostic& d : p.diagnostics.all()) {
    result.push_back(std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " +
                     d.code + " " + d.message);
  }
  return result;
}

inline Diagnostic only_error(std::string_view source) {
  const Parsed p = parsed(source);
  REQUIRE_MESSAGE(p.diagnostics.all().size() == 1, source);
  return p.diagnostics.all().front();
}

using Errors = std::vector<std::string>;

}  // namespace rob::lang
