#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>

namespace forefront::testing {

/// An empty folder with an unused name, deleted with the object.
class TemporaryFolder {
  public:
    TemporaryFolder() : path(make()) {}
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    std::filesystem::path operator/(std::string_view name) const { return path / name; }
    /// Returns the number of files in it, those in its folders included.
    std::size_t fileCount() const {
        std::size_t count = 0;
        for (const auto &entry : std::filesystem::recursive_directory_iterator(path)) {
            count += entry.is_directory() ? 0 : 1;
        }
        return count;
    }

    const std::filesystem::path path;

  private:
    static std::filesystem::path make() {
        std::string pattern = (std::filesystem::temp_directory_path() / "forefront-test-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) {
            std::perror(pattern.c_str());
            std::abort();
        }
        return pattern;
    }
};

} // namespace forefront::testing
