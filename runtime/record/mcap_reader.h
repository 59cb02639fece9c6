#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/files/files.h"
#include "runtime/record/recorded_file.h"

namespace rob::runtime {

/// Reads an MCAP file from its beginning to its end, without its indexes: one that was cut off is
/// read as far as it goes. Compressed chunks are refused: Rob writes none.
class McapReader {
 public:
  struct Message {
    std::uint64_t time = 0;  ///< ns
    std::string text;
  };

  /// Throws FileError if it cannot be read or is no MCAP file.
  explicit McapReader(const std::string& path);

  /// The attachments before the first message. Throws FileError if the file is damaged.
  std::vector<RecordedFile> attachments();
  /// The next message of a topic; false at the end. Throws FileError if the file is damaged.
  bool next(std::string_view topic, Message& message);

 private:
  bool read_record();
  bool enter_chunk();
  void learn_channel();
  [[noreturn]] void damaged() const;

  std::string path_;
  FileHandle file_;
  std::uint64_t left_ = 0;  ///< bytes of the file
  std::uint8_t opcode_ = 0;
  std::string content_;
  bool held_ = false;  ///< a record that was read waits for next()
  std::string chunk_;
  std::size_t at_ = 0;  ///< in the chunk
  std::map<std::uint16_t, std::string> topics_;
};

}  // namespace rob::runtime
