#include "runtime/record/mcap_writer.h"

#include <zlib.h>

#include <algorithm>

#include "runtime/record/mcap_bytes.h"
#include "runtime/words/version.h"

namespace rob::runtime {

using namespace mcap;

namespace {

std::uint32_t checksum(std::uint32_t before, std::string_view bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string record(std::uint8_t opcode, std::string_view content) {
  std::string bytes(1, static_cast<char>(opcode));
  put64(bytes, content.size());
  return bytes.append(content);
}

std::string schema_content(std::uint16_t id, const std::string& name, const std::string& schema) {
  std::string bytes;
  put16(bytes, id);
  put_text(bytes, name);
  put_text(bytes, "jsonschema");
  put_text(bytes, schema);
  return bytes;
}

std::string channel_content(std::uint16_t id, std::uint16_t schema, const std::string& topic) {
  std::string bytes;
  put16(bytes, id);
  put16(bytes, schema);
  put_text(bytes, topic);
  put_text(bytes, "json");
  put_text(bytes, "");  // a map of no entries
  return bytes;
}

}  // namespace

McapWriter::McapWriter(const std::string& path) : file_(open_log(path)) {
  put(kMagic);
  std::string header;
  put_text(header, "");  // no profile
  put_text(header, kVersion);
  put_record(kHeader, header);
}

/// A piece at a time, so that a full disk is noticed with the piece that no longer fits.
void McapWriter::put(std::string_view bytes) {
  if (full_) return;
  full_ = std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
          std::fflush(file_.get()) != 0;
  size_ += bytes.size();
  checksum_ = checksum(checksum_, bytes);
}

void McapWriter::put_record(std::uint8_t opcode, std::string_view content) {
  put(record(opcode, content));
}

std::uint16_t McapWriter::add_channel(const std::string& topic, const std::string& schema_name,
                                      const std::string& schema) {
  const auto number = static_cast<std::uint16_t>(topics_.size() + 1);
  Topic made;
  made.schema_record = record(kSchema, schema_content(number, schema_name, schema));
  made.record = record(kChannel, channel_content(number, number, topic));
  put(made.schema_record);
  put(made.record);
  topics_.push_back(std::move(made));
  return number;
}

void McapWriter::add_message(std::uint16_t channel, std::uint64_t time, std::string_view text) {
  Topic& of = topics_.at(channel - 1U);
  std::string content;
  put16(content, channel);
  put32(content, of.sequence++);
  put64(content, time);
  put64(content, time);
  content += text;
  const std::string message = record(kMessage, content);
  if (!chunk_.empty() && chunk_.size() + message.size() > kChunk) end_chunk();
  if (full_) ++lost_;
  chunk_first_ = chunk_.empty() ? time : std::min(chunk_first_, time);
  chunk_last_ = chunk_.empty() ? time : std::max(chunk_last_, time);
  first_ = messages_ == 0 ? time : std::min(first_, time);
  last_ = std::max(last_, time);
  places_[channel].emplace_back(time, chunk_.size());
  chunk_ += message;
  ++of.messages;
  ++messages_;
}

void McapWriter::end_chunk() {
  if (chunk_.empty()) return;
  std::string content;
  put64(content, chunk_first_);
  put64(content, chunk_last_);
  put64(content, chunk_.size());
  put32(content, checksum(0, chunk_));
  put_text(content, "");  // no compression
  put64(content, chunk_.size());
  content += chunk_;
  const std::uint64_t begin = size_;
  put_record(kChunkRecord, content);
  const std::uint64_t end = size_;

  std::string offsets;
  for (const auto& [channel, places] : places_) {
    put16(offsets, channel);
    put64(offsets, size_);
    std::string index;
    put16(index, channel);
    put32(index, static_cast<std::uint32_t>(16 * places.size()));
    for (const auto& [time, offset] : places) {
      put64(index, time);
      put64(index, offset);
    }
    put_record(kMessageIndex, index);
  }
  std::string index;
  put64(index, chunk_first_);
  put64(index, chunk_last_);
  put64(index, begin);
  put64(index, end - begin);
  put_text(index, offsets);
  put64(index, size_ - end);
  put_text(index, "");
  put64(index, chunk_.size());
  put64(index, chunk_.size());
  chunk_indexes_.push_back(record(kChunkIndex, index));
  chunk_.clear();
  places_.clear();
}

void McapWriter::attach(const std::string& name, const std::string& media_type,
                        std::string_view data) {
  end_chunk();
  std::string content;
  put64(content, 0);  // of the log, and of the file: the run's start
  put64(content, 0);
  put_text(content, name);
  put_text(content, media_type);
  put64(content, data.size());
  content += data;
  put32(content, checksum(0, content));
  const std::uint64_t begin = size_;
  put_record(kAttachment, content);
  std::string index;
  put64(index, begin);
  put64(index, size_ - begin);
  put64(index, 0);
  put64(index, 0);
  put64(index, data.size());
  put_text(index, name);
  put_text(index, media_type);
  attachment_indexes_.push_back(record(kAttachmentIndex, index));
}

/// Schemas, channels, statistics and indexes, then where each of these groups begins; the footer
/// up to its checksum.
std::string McapWriter::summary(std::uint64_t begin) {
  std::string statistics;
  put64(statistics, messages_);
  put16(statistics, static_cast<std::uint16_t>(topics_.size()));
  put32(statistics, static_cast<std::uint32_t>(topics_.size()));
  put32(statistics, static_cast<std::uint32_t>(attachment_indexes_.size()));
  put32(statistics, 0);  // metadata
  put32(statistics, static_cast<std::uint32_t>(chunk_indexes_.size()));
  put64(statistics, first_);
  put64(statistics, last_);
  std::string counts;
  std::string schemas;
  std::string channels;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    put16(counts, static_cast<std::uint16_t>(i + 1));
    put64(counts, topics_[i].messages);
    schemas += topics_[i].schema_record;
    channels += topics_[i].record;
  }
  put_text(statistics, counts);
  std::string chunks;
  for (const std::string& index : chunk_indexes_) chunks += index;
  std::string attachments;
  for (const std::string& index : attachment_indexes_) attachments += index;

  const std::pair<std::uint8_t, std::string> groups[] = {
      {kSchema, schemas},
      {kChannel, channels},
      {kStatistics, record(kStatistics, statistics)},
      {kChunkIndex, chunks},
      {kAttachmentIndex, attachments}};
  std::string text;
  std::string offsets;
  for (const auto& [opcode, group] : groups) {
    if (group.empty()) continue;
    std::string offset(1, static_cast<char>(opcode));
    put64(offset, begin + text.size());
    put64(offset, group.size());
    offsets += record(kSummaryOffset, offset);
    text += group;
  }
  const std::uint64_t offsets_begin = begin + text.size();
  text += offsets;
  text += static_cast<char>(kFooter);
  put64(text, 20);  // bytes of the footer
  put64(text, begin);
  put64(text, offsets_begin);
  return text;
}

bool McapWriter::close() {
  end_chunk();
  std::string end;
  put32(end, checksum_);
  put_record(kDataEnd, end);
  std::string text = summary(size_);
  put32(text, checksum(0, text));
  put(text);
  put(kMagic);
  return std::fclose(file_.release()) == 0 && !full_;
}

}  // namespace rob::runtime
