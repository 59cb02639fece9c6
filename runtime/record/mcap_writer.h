#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/files/files.h"

namespace rob::runtime {

/// Writes an MCAP file (mcap.dev/spec, version 0): messages in uncompressed chunks with indexes,
/// attachments, a summary, and checksums. Times in ns. When the disk is full the file stops
/// growing, and close() says so.
class McapWriter {
 public:
  static constexpr std::size_t kChunk = 1 << 20;  ///< bytes of a chunk at most

  /// Opens the file at once: throws FileError.
  explicit McapWriter(const std::string& path);

  /// `schema`: a JSON Schema, or empty for none. Returns the number of the channel.
  std::uint16_t add_channel(const std::string& topic, const std::string& schema_name,
                            const std::string& schema);
  /// A JSON text.
  void add_message(std::uint16_t channel, std::uint64_t time, std::string_view text);
  /// A file: after the channels, before the messages or after them.
  void attach(const std::string& name, const std::string& media_type, std::string_view data);
  /// Writes the summary; false if not all of it is in the file.
  bool close();
  std::int64_t lost() const { return lost_; }  ///< messages that could not be written

 private:
  struct Topic {
    std::string schema_record;
    std::string record;
    std::uint32_t sequence = 0;
    std::uint64_t messages = 0;
  };
  using Places = std::vector<std::pair<std::uint64_t, std::uint64_t>>;  // time, offset in the chunk

  void put(std::string_view bytes);
  void put_record(std::uint8_t opcode, std::string_view content);
  void end_chunk();
  std::string summary(std::uint64_t begin);

  FileHandle file_;
  bool full_ = false;
  std::int64_t lost_ = 0;
  std::uint64_t size_ = 0;
  std::uint32_t checksum_ = 0;  // of all that was written
  std::vector<Topic> topics_;
  std::string chunk_;
  std::map<std::uint16_t, Places> places_;  // of the messages in the chunk
  std::uint64_t chunk_first_ = 0;
  std::uint64_t chunk_last_ = 0;
  std::uint64_t first_ = 0;
  std::uint64_t last_ = 0;
  std::uint64_t messages_ = 0;
  std::vector<std::string> chunk_indexes_;
  std::vector<std::string> attachment_indexes_;
};

}  // namespace rob::runtime
