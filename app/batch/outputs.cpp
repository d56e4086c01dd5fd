#include "app/batch/outputs.hpp"

#include "core/io/files.hpp"

#include <algorithm>
#include <cctype>

namespace forefront {

namespace {

/// A word of each format that can be written, each once.
std::string listOf(const char *FileFormat::*word) {
    std::string list;
    for (const FileFormat &format : fileFormats()) {
        if (format.writesMesh && (", " + list + ',').find(std::string(" ") + format.*word + ',') == std::string::npos) {
            list += (list.empty() ? "" : ", ") + std::string(format.*word);
        }
    }
    return list;
}

} // namespace

std::string formatIds() {
    return listOf(&FileFormat::id);
}

std::string checkFormat(const std::filesystem::path &output, const std::string &id) {
    std::string extension = output.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto formats = fileFormats();
    const auto find = [&](auto wanted) {
        const auto found = std::find_if(formats.begin(), formats.end(), wanted);
        return found == formats.end() ? nullptr : &*found;
    };
    const auto extensionIs = [&](const FileFormat &format) { return extension == format.extension; };
    if (id.empty()) {
        const FileFormat *meant = find([&](const FileFormat &f) { return f.writesMesh && extensionIs(f); });
        return meant != nullptr ? ""
                                : "-o " + output.string() + ": no format has the extension '" + extension +
                                      "'; extensions: " + listOf(&FileFormat::extension);
    }
    const FileFormat *wanted = find([&](const FileFormat &f) { return f.writesMesh && id == f.id; });
    if (wanted == nullptr) {
        return "--format: unknown format '" + id + "'; formats: " + formatIds();
    }
    const FileFormat *named = find(extensionIs);
    if (named != nullptr && !extensionIs(*wanted)) {
        return "-o " + output.string() + " is named as " + named->name + ", but --format " + id + " is " +
               wanted->name + " (" + wanted->extension + "); formats go to the outputs in their order";
    }
    return {};
}

Diagnostics checkOutputs(const std::vector<std::filesystem::path> &paths) {
    Diagnostics faults;
    std::error_code none;
    const auto refuse = [&](const std::filesystem::path &path, std::string message, std::string advice) {
        faults.push_back(error("cannot-write", std::move(message), std::move(advice)).front());
        faults.back().file = path.string();
    };
    for (const std::filesystem::path &path : paths) {
        const std::filesystem::path folder = path.parent_path();
        if (std::filesystem::is_directory(path, none)) {
            refuse(path, "cannot write the file: it is a folder", "name a file in it");
        } else if (!folder.empty() && !std::filesystem::is_directory(folder, none)) {
            refuse(path, "cannot write the file: there is no folder " + folder.string(), "make it, or choose another");
        }
    }
    return faults;
}

} // namespace forefront
