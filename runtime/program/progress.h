#pragma once

namespace rob::runtime {

/// A line at the bottom of a terminal that tells how far a run is: source line, time, time left as
/// planned. Prints nothing where stderr is no terminal.
class Progress {
 public:
  /// `planned`: s, or 0 where it is not known.
  explicit Progress(double planned);

  void show(int line, double time);
  /// Makes room for other output.
  void clear();

 private:
  double planned_;
  bool terminal_;
  bool shown_ = false;
  double last_ = -1;
};

}  // namespace rob::runtime
