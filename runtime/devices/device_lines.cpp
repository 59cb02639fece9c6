#include "runtime/devices/device_lines.h"

#include <utility>

#include "lang/text/utf8.h"

namespace rob::runtime {

namespace {

std::string as_utf8(std::string_view bytes) {
  constexpr char32_t kReplacement = 0xFFFD;
  std::string text;
  while (!bytes.empty()) {
    const lang::CodePoint point = lang::decode_utf8(bytes);
    const bool valid = point.length > 0 && point.value != 0;
    lang::append_utf8(text, valid ? point.value : kReplacement);
    bytes.remove_prefix(point.length > 0 ? point.length : 1);
  }
  return text;
}

}  // namespace

void DeviceLines::add(std::string_view bytes) {
  while (!bytes.empty()) {
    // Up to where a line may end, if it does.
    const std::size_t last = bytes.find(ending_.back());
    const std::string_view piece =
        bytes.substr(0, last == std::string_view::npos ? last : last + 1);
    bytes.remove_prefix(piece.size());
    begun_ += piece;
    if (begun_.ends_with(ending_)) {
      end_line();
    } else if (begun_.size() > kLongest + ending_.size()) {
      too_long_ = true;
      begun_.erase(0, begun_.size() - ending_.size());  // perhaps its end begins here
    }
  }
}

void DeviceLines::end_line() {
  begun_.resize(begun_.size() - ending_.size());
  const std::string line = std::exchange(begun_, "");
  if (std::exchange(too_long_, false) || line.size() > kLongest) {
    ++dropped_;
  } else {
    keep(as_utf8(line));
  }
}

void DeviceLines::break_off() {
  begun_.clear();
  too_long_ = false;
}

void DeviceLines::keep(std::string line) {
  waiting_ += line.size() + 1;
  lines_.push_back(std::move(line));
  while (waiting_ > kMostWaiting) {
    take();
    ++dropped_;
  }
}

std::optional<std::string> DeviceLines::take() {
  if (lines_.empty()) return std::nullopt;
  std::string line = std::move(lines_.front());
  lines_.pop_front();
  waiting_ -= line.size() + 1;
  return line;
}

void DeviceLines::clear() {
  lines_.clear();
  waiting_ = 0;
}

std::size_t DeviceLines::take_dropped() { return std::exchange(dropped_, 0); }

}  // namespace rob::runtime
