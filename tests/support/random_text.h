#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace rob::test {

/// Seeded choices that come out alike on every machine, unlike the standard distributions.
class Choice {
 public:
  explicit Choice(std::uint64_t seed) : engine_(seed) {}

  /// 0 … count − 1
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  int between(int least, int greatest) { return least + below(greatest - least + 1); }
  bool percent(int share) { return below(100) < share; }

  template <typename T>
  const T& of(const std::vector<T>& things) {
    return things[static_cast<std::size_t>(below(static_cast<int>(things.size())))];
  }

 private:
  std::mt19937_64 engine_;
};

/// A quantity as it stands in a program, and its value in mm, deg or s (or their rates).
struct WrittenQuantity {
  std::string text;
  double value = 0;
};

/// `units` · 10^−decimals in plain decimal writing: decimal(1234, 2) is "12.34".
std::string decimal(std::int64_t units, int decimals);

/// So many tenths of a millimetre, in any unit that writes them exactly, or bare.
WrittenQuantity written_length(Choice& choice, int tenths_of_mm);

/// An angle near so many tenths of a degree, in any unit, or bare. The value is that of the text.
WrittenQuantity written_angle(Choice& choice, int tenths_of_deg);

/// A time near so many tenths of a second.
WrittenQuantity written_time(Choice& choice, int tenths_of_s);

}  // namespace rob::test
