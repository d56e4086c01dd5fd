#include "app/batch/outputs.hpp"

#include "core/io/files.hpp"

#include <algorithm>
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

Diagnostics checkOutputs(const std::vector<Output> &outputs, const std::vector<std::filesystem::path> &inputs) {
    Diagnostics faults;
    std::set<std::filesystem::path> read, written;
    const auto addTo = [](std::set<std::filesystem::path> &files, const std::vector<std::filesystem::path> &more) {
        bool added = true;
        for (const std::filesystem::path &file : more) {
            std::error_code none;
            const std::filesystem::file_status kind = std::filesystem::status(file, none);
            if (!std::filesystem::exists(kind) || std::filesystem::is_regular_file(kind)) { // a device takes all
                added = files.insert(resolved(file)).second && added;
            }
        }
        return added;
    };
    for (const std::filesystem::path &path : inputs) {
        addTo(read, filesRead(path));
    }
    for (const Output &output : outputs) {
        const std::vector<std::filesystem::path> files = filesOfMesh(output.path, output.format);
        Diagnostics wrong = checkPlace(output.path);
        if (wrong.empty() && std::any_of(files.begin(), files.end(), [&](const std::filesystem::path &file) {
                return read.count(resolved(file)) > 0;
            })) {
            wrong = error("cannot-write", "cannot write the file: it is an input", "choose another name");
        } else if (wrong.empty() && !addTo(written, files)) {
            wrong = error("cannot-write", "cannot write two outputs to one file", "give each a name of its own");
        }
        for (Diagnostic &fault : wrong) {
            fault.file = output.path.string();
            faults.push_back(std::move(fault));
        }
    }
    return faults;
}

} // namespace forefront
