#include "app/batch/outputs.hpp"

#include "core/io/files.hpp"

#include <algorithm>
#include <array>
#include <set>

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

std::filesystem::path resolved(const std::filesystem::path &file) {
    std::error_code none;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file, none), none);
}

/// The files that go with a name: those of a mesh of Triangle stand side by side.
std::vector<std::filesystem::path> withCompanions(const std::filesystem::path &path) {
    static constexpr std::array<std::string_view, 3> kTriangle{".node", ".ele", ".edge"};
    if (std::find(kTriangle.begin(), kTriangle.end(), path.extension().string()) == kTriangle.end()) {
        return {path};
    }
    std::vector<std::filesystem::path> files;
    for (const std::string_view extension : kTriangle) {
        files.push_back(path);
        files.back().replace_extension(extension);
    }
    return files;
}

} // namespace

std::string formatIds() {
    return listOf(&FileFormat::id);
}

std::string checkFormat(const std::filesystem::path &output, const std::string &id) {
    const std::vector<const FileFormat *> named = fileFormatsNamed(output);
    if (id.empty()) {
        const bool known = std::any_of(named.begin(), named.end(), [](const FileFormat *f) { return f->writesMesh; });
        return known ? ""
                     : "-o " + output.string() + ": no format has the extension '" + output.extension().string() +
                           "'; extensions: " + listOf(&FileFormat::extension);
    }
    const auto formats = fileFormats();
    const auto wanted =
        std::find_if(formats.begin(), formats.end(), [&](const FileFormat &f) { return f.writesMesh && id == f.id; });
    if (wanted == formats.end()) {
        return "--format: unknown format '" + id + "'; formats: " + formatIds();
    }
    if (!named.empty() && std::find(named.begin(), named.end(), &*wanted) == named.end()) {
        return "-o " + output.string() + " is named as " + named.front()->name + ", but --format " + id + " is " +
               wanted->name + " (" + wanted->extension + "); formats go to the outputs in their order";
    }
    return {};
}

Diagnostics checkOutputs(const std::vector<std::filesystem::path> &outputs,
                         const std::vector<std::filesystem::path> &inputs) {
    Diagnostics faults;
    std::error_code none;
    std::set<std::filesystem::path> read, written;
    const auto addTo = [&](std::set<std::filesystem::path> &files, const std::filesystem::path &path) {
        bool added = true;
        for (const std::filesystem::path &file : withCompanions(path)) {
            const std::filesystem::file_status kind = std::filesystem::status(file, none);
            if (!std::filesystem::exists(kind) || std::filesystem::is_regular_file(kind)) { // a device takes all
                added = files.insert(resolved(file)).second && added;
            }
        }
        return added;
    };
    const auto isInput = [&](const std::filesystem::path &path) {
        const std::vector<std::filesystem::path> files = withCompanions(path);
        return std::any_of(files.begin(), files.end(),
                           [&](const std::filesystem::path &file) { return read.count(resolved(file)) > 0; });
    };
    for (const std::filesystem::path &path : inputs) {
        addTo(read, path);
    }
    const auto refuse = [&](const std::filesystem::path &path, std::string message, std::string advice) {
        faults.push_back(error("cannot-write", std::move(message), std::move(advice)).front());
        faults.back().file = path.string();
    };
    for (const std::filesystem::path &path : outputs) {
        const std::filesystem::path folder = path.parent_path();
        if (path.empty()) {
            refuse(path, "cannot write a file without a name", "name one");
        } else if (std::filesystem::is_directory(path, none)) {
            refuse(path, "cannot write the file: it is a folder", "name a file in it");
        } else if (!folder.empty() && !std::filesystem::is_directory(folder, none)) {
            refuse(path, "cannot write the file: there is no folder " + folder.string(), "make it, or choose another");
        } else if (isInput(path)) {
            refuse(path, "cannot write the file: it is an input", "choose another name");
        } else if (!addTo(written, path)) {
            refuse(path, "cannot write two outputs to one file", "give each a name of its own");
        }
    }
    return faults;
}

} // namespace forefront
