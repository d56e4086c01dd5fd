#pragma once

#include "core/edit/document.hpp"
#include "core/io/source.hpp"
#include "core/mesh/mesh.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace forefront::testing {

/// A folder of its own that disappears with the object.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder &) = delete;
    ScratchFolder &operator=(const ScratchFolder &) = delete;
    std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
    const std::filesystem::path &path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// A document that uses every field of the project file.
Document fullDocument();

/// Source text for a reader, not backed by a file.
inline SourceText sourceOf(std::string_view text, std::string name = "memory") {
    return {text, std::move(name), {}, {}};
}

/// All messages of a list, one a line.
std::string messages(const Diagnostics &faults);

/// True if one of the faults has that code.
bool hasCode(const Diagnostics &faults, std::string_view code);

/// True if every error names its file and line.
bool allLocated(const Diagnostics &faults);

} // namespace forefront::testing
