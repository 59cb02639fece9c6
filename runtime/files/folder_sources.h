#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "lang/syntax/used_files.h"

namespace rob::runtime {

/// Finds USEd files on the disk: `tools.rob` for `USE tools`, in the folder of the file that USEs
/// it, then in the folder `lib` beside the program. Capital and small letters count, as they do in
/// the names of files.
class FolderSources final : public lang::Sources {
 public:
  /// `program`: its file, as people call it; it need not exist.
  explicit FolderSources(const std::string& program);

  const lang::SourceFile& program() const override { return program_; }
  std::variant<lang::SourceFile, lang::NoSource> find(std::string_view name,
                                                      const std::string& by) const override;

 private:
  lang::SourceFile program_;
};

}  // namespace rob::runtime
