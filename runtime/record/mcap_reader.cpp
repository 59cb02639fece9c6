#include "runtime/record/mcap_reader.h"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "runtime/record/mcap_bytes.h"

namespace rob::runtime {

using namespace mcap;

namespace {

constexpr std::uint64_t kMostRecord = std::uint64_t{64} << 20U;  // bytes [choice]
constexpr std::size_t kRecordHead = 9;                           // opcode and length

}  // namespace

McapReader::McapReader(const std::string& path) : path_(path) {
  std::error_code error;
  left_ = std::filesystem::file_size(path, error);
  if (error)
    throw FileError(
        fmt::format("cannot read '{}': {}; check the name and the folder", path, error.message()));
  file_.reset(std::fopen(path.c_str(), "rb"));
  std::string magic(kMagic.size(), '\0');
  if (!file_) throw FileError(fmt::format("cannot read '{}'", path));
  if (std::fread(magic.data(), 1, magic.size(), file_.get()) != magic.size() || magic != kMagic)
    throw FileError(
        fmt::format("'{}' is no MCAP file; rob run PROGRAM --mcap FILE writes one", path));
  left_ -= magic.size();
}

void McapReader::damaged() const {
  throw FileError(fmt::format(
      "'{}' is damaged, or is not of Rob; record the run again with rob run --mcap", path_));
}

/// The next record of the file; false at the end of its data.
bool McapReader::read_record() {
  std::string head(kRecordHead, '\0');
  if (std::fread(head.data(), 1, head.size(), file_.get()) != head.size()) return false;
  left_ -= head.size();
  Bytes bytes(head);
  opcode_ = bytes.number<std::uint8_t>();
  const auto size = bytes.number<std::uint64_t>();
  if (size > left_) return false;  // it was cut off
  if (size > kMostRecord) damaged();
  content_.resize(size);
  if (std::fread(content_.data(), 1, size, file_.get()) != size) return false;
  left_ -= size;
  return opcode_ != kDataEnd && opcode_ != kFooter;
}

void McapReader::learn_channel() {
  Bytes bytes(content_);
  const auto id = bytes.number<std::uint16_t>();
  bytes.number<std::uint16_t>();  // its schema
  topics_[id] = bytes.text();
  if (!bytes.good()) damaged();
}

bool McapReader::enter_chunk() {
  Bytes bytes(content_);
  bytes.take(8 + 8 + 8 + 4);  // first and last time, size, checksum
  if (!bytes.text().empty()) damaged();
  const auto size = bytes.number<std::uint64_t>();
  if (!bytes.good() || size != bytes.left()) damaged();
  chunk_ = bytes.take(size);
  at_ = 0;
  return !chunk_.empty();
}

std::vector<RecordedFile> McapReader::attachments() {
  std::vector<RecordedFile> files;
  while (read_record()) {
    if (opcode_ == kChannel) learn_channel();
    if (opcode_ == kChunkRecord) {
      held_ = true;
      break;
    }
    if (opcode_ != kAttachment) continue;
    Bytes bytes(content_);
    bytes.take(8 + 8);  // times
    RecordedFile file;
    file.name = bytes.text();
    file.media_type = bytes.text();
    file.text = bytes.take(bytes.number<std::uint64_t>());
    if (!bytes.good()) damaged();
    files.push_back(std::move(file));
  }
  return files;
}

bool McapReader::next(std::string_view topic, Message& message) {
  for (;;) {
    while (at_ < chunk_.size()) {
      Bytes bytes(std::string_view(chunk_).substr(at_));
      const auto opcode = bytes.number<std::uint8_t>();
      const auto size = bytes.number<std::uint64_t>();
      Bytes content(bytes.take(size));
      if (!bytes.good()) damaged();
      at_ += kRecordHead + size;
      if (opcode != kMessage) continue;
      const auto channel = topics_.find(content.number<std::uint16_t>());
      content.number<std::uint32_t>();  // its number
      message.time = content.number<std::uint64_t>();
      content.number<std::uint64_t>();
      if (!content.good()) damaged();
      if (channel == topics_.end() || channel->second != topic) continue;
      message.text = content.take(content.left());
      return true;
    }
    if (!held_ && !read_record()) return false;
    held_ = false;
    if (opcode_ == kChannel) learn_channel();
    if (opcode_ == kChunkRecord) enter_chunk();
  }
}

}  // namespace rob::runtime
