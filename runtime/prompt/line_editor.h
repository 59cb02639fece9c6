#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/prompt/completion.h"

namespace rob::runtime {

/// The line that is being typed at the terminal: editing, completion and history by GNU readline.
/// It never waits, so that a robot can report meanwhile. One object at a time; the terminal is its
/// own while it lives.
class LineEditor {
 public:
  /// The width of the text left of the cursor.
  using Completer = std::function<Completions(std::string_view before)>;

  /// `history`: where lines are kept from one start to the next; empty: nowhere.
  LineEditor(Completer completer, std::string history);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// A new line, after the prompt; `indent` and `text` stand in it already.
  void begin(const std::string& prompt, const std::string& indent = "",
             const std::string& text = "");
  /// Of the line under way; what has been typed and the cursor stay.
  void change_prompt(const std::string& prompt);
  /// Takes what has been typed until there is no more, or a line is complete.
  void read();
  /// The line that read() has completed, once.
  std::optional<std::string> take_line();
  /// Characters were there already when the line was complete: nobody types that fast, so they are
  /// of the same paste, of a terminal that does not mark it.
  bool followed() const { return followed_; }
  /// Those, up to the first pause; they are not typed any more.
  std::string take_followers();
  /// Ctrl-D at the beginning of a line.
  bool ended() const { return ended_; }
  /// The line under way is dropped; begin() has to follow.
  void drop();
  /// Nothing stands in the line under way, or is pasted before it.
  bool empty() const;
  /// The history has this as one more entry, of any number of lines.
  void keep(const std::string& entry);

  /// Of the terminal.
  static int columns();

  /// For output: takes the line off the screen, and puts it back.
  void hide();
  void show();

 private:
  static void accept(char* line);
  static char** complete(const char* word, int begin, int end);
  static int put_in();
  static int enter(int count, int key);
  static int paste(int count, int key);
  void hold(const std::string& text);

  Completer completer_;
  std::string history_;
  std::string indent_;
  std::string text_;    ///< that stands in the line at first
  std::string pasted_;  ///< text that is too long for the screen; it stands before the line
  std::optional<std::string> line_;
  bool editing_ = false;
  bool hidden_ = false;
  bool ended_ = false;
  bool followed_ = false;
};

}  // namespace rob::runtime
