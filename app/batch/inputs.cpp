#include "app/batch/inputs.hpp"

#include "app/batch/exit_code.hpp"
#include "core/io/files.hpp"
#include "core/io/source/source.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

bool Input::isProject() const {
    constexpr std::string_view kProject = "project";
    if (!options.formatId.empty()) {
        return options.formatId == kProject;
    }
    std::error_code none;
    const FileFormat *format = nullptr;
    if (options.content != nullptr) {
        format = fileFormatOf({}, *options.content);
    } else if (std::filesystem::is_regular_file(path, none)) {
        format = fileFormatOf(path);
    } else { // a pipe can be read only once
        const std::vector<const FileFormat *> named = fileFormatsNamed(path);
        format = named.empty() ? nullptr : named.front();
    }
    return format != nullptr && format->id == kProject;
}

Result<Input> openInput(const std::filesystem::path &path, const std::string &formatId) {
    Input input{path, {}};
    input.options.formatId = formatId;
    if (isStandardStream(path)) {
        Result<std::string> bytes = readStandardInput(input.options.maxBytes);
        if (!bytes) {
            return bytes.faults();
        }
        input.path = "standard input";
        input.options.content = std::make_shared<const std::string>(std::move(*bytes));
    }
    return input;
}

std::string inputFormatIds() {
    std::string list;
    for (const FileFormat &format : fileFormats()) {
        if (format.readsDomain || format.readsMesh) {
            list += (list.empty() ? "" : ", ") + std::string(format.id);
        }
    }
    return list;
}

std::string checkInputs(std::initializer_list<std::optional<std::filesystem::path>> inputs,
                        const std::string &formatId) {
    const auto fromStream =
        std::count_if(inputs.begin(), inputs.end(), [](const auto &path) { return path && isStandardStream(*path); });
    if (fromStream > 1) {
        return "more than one input is '-'; standard input can be read only once";
    }
    const auto formats = fileFormats();
    const bool known = formatId.empty() || std::any_of(formats.begin(), formats.end(), [&](const FileFormat &format) {
                           return formatId == format.id && (format.readsDomain || format.readsMesh);
                       });
    return known ? std::string()
                 : "--input-format: unknown format '" + formatId + "'; expected one of " + inputFormatIds();
}

void printNotes(const ImportNotes &notes, bool quiet) {
    if (!quiet) {
        printFaults(notes.diagnostics());
    }
}

} // namespace forefront
