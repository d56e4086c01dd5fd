#include "ui/dialogs/file_list.hpp"

#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace forefront {
namespace {

std::int64_t seconds(std::filesystem::file_time_type time) {
    const auto system = std::chrono::file_clock::to_sys(time);
    return std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count();
}

bool endsWithOneOf(std::string_view name, const std::vector<std::string> &extensions) {
    const std::string text = lowerCase(name);
    return std::any_of(extensions.begin(), extensions.end(), [&](const std::string &extension) {
        return text.size() > extension.size() && text.ends_with(extension);
    });
}

} // namespace

bool passes(const FileFilter &filter, std::string_view name) {
    return filter.extensions.empty() || endsWithOneOf(name, filter.extensions);
}

std::vector<FileFilter> openFilters(std::string all, const std::vector<FileFilter> &given,
                                    const std::function<bool(const FileFormat &)> &reads) {
    std::vector<FileFilter> filters{{std::move(all), {}, "all"}};
    filters.insert(filters.end(), given.begin(), given.end());
    const auto known = [&](const std::string &extension) {
        return std::any_of(filters.begin() + 1, filters.end(),
                           [&](const FileFilter &filter) { return passes(filter, "x" + extension); });
    };
    for (const FileFormat &format : allFormats().list()) {
        if (reads(format) && !known(format.extension)) {
            filters.push_back(
                {std::string(format.name) + " (" + format.extension + ")", {format.extension}, format.id});
        }
    }
    for (std::size_t k = 1; k < filters.size(); ++k) {
        const std::vector<std::string> &each = filters[k].extensions;
        filters.front().extensions.insert(filters.front().extensions.end(), each.begin(), each.end());
    }
    filters.push_back({"All files", {}, "any"});
    return filters;
}

Diagnostics checkExtension(std::string_view name, const std::vector<FileFilter> &filters) {
    const std::string extension = std::filesystem::path(name).extension().string();
    const bool known =
        std::any_of(filters.begin(), filters.end(), [&](const FileFilter &filter) { return passes(filter, name); });
    if (extension.size() < 2 || known) {
        return {};
    }
    std::string expected;
    for (const FileFilter &filter : filters) {
        for (const std::string &each : filter.extensions) {
            if (expected.find(each + ",") == std::string::npos) {
                expected += each + ", ";
            }
        }
    }
    expected.resize(expected.size() - 2);
    if (const std::size_t last = expected.rfind(", "); last != std::string::npos) {
        expected.replace(last, 2, " or ");
    }
    return error("unknown-extension", "unknown file extension '" + extension + "'; expected " + expected);
}

std::string withExtension(std::string name, const FileFilter &filter, const std::vector<FileFilter> &others) {
    if (filter.extensions.empty() || name.empty() || passes(filter, name)) {
        return name;
    }
    for (const FileFilter &other : others) {
        if (!other.extensions.empty() && passes(other, name)) {
            name.erase(name.rfind('.'));
            break;
        }
    }
    return name + filter.extensions.front();
}

Result<std::vector<FileEntry>> listFolder(const std::filesystem::path &folder, const FileFilter &filter) {
    std::vector<FileEntry> entries;
    std::error_code failed;
    std::filesystem::directory_iterator entry(folder, failed);
    for (const std::filesystem::directory_iterator end; !failed && entry != end; entry.increment(failed)) {
        FileEntry file;
        file.name = entry->path().filename().string();
        std::error_code ignored;
        file.folder = entry->is_directory(ignored);
        if (file.name.starts_with('.') || (!file.folder && !passes(filter, file.name))) {
            continue;
        }
        if (!file.folder) {
            file.size = entry->file_size(ignored);
            if (ignored) {
                file.size = 0;
            }
        }
        const auto time = entry->last_write_time(ignored);
        file.modified = ignored ? 0 : seconds(time);
        entries.push_back(std::move(file));
    }
    if (failed) {
        return error("folder", folder.string() + ": " + failed.message());
    }
    std::sort(entries.begin(), entries.end(), [](const FileEntry &a, const FileEntry &b) {
        if (a.folder != b.folder) {
            return a.folder;
        }
        const std::string left = lowerCase(a.name), right = lowerCase(b.name);
        return left != right ? left < right : a.name < b.name;
    });
    return entries;
}

std::filesystem::path resolved(const std::filesystem::path &folder, std::string_view typed) {
    std::filesystem::path path(typed);
    const char *home = std::getenv("HOME");
    if (home != nullptr && (typed == "~" || typed.starts_with("~/"))) {
        path = std::filesystem::path(home) / typed.substr(std::min<std::size_t>(typed.size(), 2));
    }
    if (path.is_relative()) {
        path = folder / path;
    }
    path = path.lexically_normal();
    return path.has_filename() || !path.has_parent_path() ? path : path.parent_path();
}

std::string fileSizeText(std::uintmax_t bytes) {
    static constexpr const char *kUnits[] = {"B", "kB", "MB", "GB", "TB"};
    double value = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (value >= 999.5 && unit + 1 < std::size(kUnits)) {
        value /= 1000.0;
        ++unit;
    }
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, unit == 0 || value >= 99.5 ? "%.0f %s" : "%.1f %s", value, kUnits[unit]);
    return buffer;
}

} // namespace forefront
