#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/machine/move_command.h"
#include "runtime/prompt/dead_man.h"
#include "runtime/prompt/key_reader.h"
#include "runtime/prompt/session.h"

namespace rob::runtime {

/// The terminal as a pendant: what its keys do to the robot of a session. Whoever reads the keys
/// hands them in, in the order in which they were pressed, and draws what view() shows.
///
/// Where the terminal reports releases, a key that is held is the dead-man; else a key is a step,
/// or a pulse that its repeats prolong and that any other key ends. Never more than one step is
/// pending.
class Pendant {
 public:
  enum class Style : unsigned char { Hold, Step, Pulse };

  /// `releases`: the terminal reports them. `session` must outlive it, and `dead_man` the robot.
  Pendant(Session& session, DeadMan& dead_man, bool releases);

  void press(const Key& key);
  /// A while has passed: what waits for the robot to stand goes on.
  void go_on();
  /// Whether the pendant has been left.
  bool over() const { return over_; }
  /// Stops what moves by it.
  void stop();
  /// Ctrl-C: stops, and forgets a name that is being typed.
  void give_up();

  // For the view.
  lang::JogFrame frame() const { return frame_; }
  Style style() const { return style_; }
  double share() const;  ///< of full speed
  double step() const;   ///< mm or deg
  std::size_t chosen() const { return chosen_; }
  /// "x", "y" … of the coordinates that the keys move.
  std::vector<std::string> coordinates() const;
  const std::optional<std::string>& naming() const { return naming_; }
  /// An output's number is the next key.
  bool choosing_output() const { return choosing_output_; }
  /// A key moves the robot now.
  bool moving() const { return active_.has_value(); }
  /// Keys can move it.
  bool can_move() const;
  /// Keys can teach a point: it stands under control, or in a hand.
  bool can_teach() const { return !session_.robot().over(); }
  /// Keys can move it in this frame: only of an arm other ones than the axes.
  bool has(lang::JogFrame frame) const;
  /// It has a digital output of this name, and it can be set now.
  bool can_set(std::string_view output) const;
  /// The number of outputs that have a key.
  int outputs() const;
  bool slowest() const { return speed_ == 0; }
  bool fastest() const;
  bool smallest_step() const { return step_ == 0; }
  bool largest_step() const;
  bool releases() const { return releases_; }
  const Session& session() const { return session_; }

 private:
  struct Way {
    std::size_t coordinate = 0;
    int sign = 1;
    bool operator==(const Way&) const = default;
  };

  std::optional<Way> way_of(const Key& key) const;
  void move(const Way& way, Key::Event event);
  void begin(const Way& way);
  void command(const Key& key);
  void name(const Key& key);
  void choose_frame(lang::JogFrame frame);
  void choose_output(const Key& key);
  void toggle(const std::string& output);
  bool linear(std::size_t coordinate) const;
  lang::MoveCommand jog(const Way& way, double rate, double lasts) const;
  double full_rate(std::size_t coordinate) const;

  Session& session_;
  DeadMan& dead_man_;
  const bool releases_;
  Style style_;
  lang::JogFrame frame_ = lang::JogFrame::Joint;
  std::size_t chosen_ = 0;
  std::size_t speed_ = 3;
  std::size_t step_ = 1;
  std::optional<Way> active_;          ///< that the robot makes
  std::optional<Way> pending_;         ///< after it
  std::optional<std::string> naming_;  ///< what has been typed of a point's name
  bool choosing_output_ = false;
  bool over_ = false;
};

}  // namespace rob::runtime
