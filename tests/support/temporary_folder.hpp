#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
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
