#include "app/batch/inputs.hpp"

#include "app/batch/exit_code.hpp"
#include "app/batch/suggestion.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/reader_options.hpp"
#include "core/files/source/source.hpp"

#include <algorithm>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Options that were given, with the words on the command line.
std::vector<std::pair<ReaderOption, std::string>> givenOptions(const DrawingArguments &drawing, bool repairs) {
    std::vector<std::pair<ReaderOption, std::string>> list;
    const auto add = [&list](bool given, ReaderOption option, const char *word) {
        if (given) {
            list.emplace_back(option, word);
        }
    };
    add(drawing.weldTolerance && !repairs, ReaderOption::Weld, "--weld");
    add(drawing.layer.has_value(), ReaderOption::Layer, "--layer");
    add(drawing.nameProperty.has_value(), ReaderOption::NameProperty, "--name-property");
    add(drawing.sizeProperty.has_value(), ReaderOption::SizeProperty, "--size-property");
    add(!drawing.projection.empty(), ReaderOption::Projection, "--projection");
    add(drawing.degrees == DegreeRule::Local, ReaderOption::Degrees, "--projection");
    add(drawing.degrees == DegreeRule::Keep, ReaderOption::Degrees, "--allow-degrees");
    add(drawing.overlap.has_value(), ReaderOption::Overlap, "--overlap");
    add(!drawing.partNames.empty(), ReaderOption::PartNames, "--name");
    add(drawing.dropLines, ReaderOption::DropLines, "--drop-lines");
    add(drawing.beyondPage, ReaderOption::BeyondPage, "--beyond-page");
    add(drawing.strokeAreas, ReaderOption::StrokeAreas, "--stroke-areas");
    add(drawing.shapeRegions, ReaderOption::ShapeRegions, "--shape-regions");
    add(drawing.whiteHoles == true, ReaderOption::WhiteHoles, "--white-holes");
    add(drawing.whiteHoles == false, ReaderOption::WhiteHoles, "--no-white-holes");
    return list;
}

/// Returns the advice that follows the reason why an option is refused.
std::string adviceOn(ReaderOption option) {
    return option == ReaderOption::Weld ? "; add --repair to join nearby nodes and segments"
           : option == ReaderOption::PartNames
               ? "; name the segments in the editor, or by the command name of 'forefront run'"
               : "";
}

} // namespace

const FileFormat *Input::format() const {
    if (!detected) {
        detected = !options.formatId.empty()    ? allFormats().withId(options.formatId)
                   : options.content != nullptr ? allFormats().detect({}, *options.content)
                                                : allFormats().detect(path);
    }
    return *detected;
}

bool Input::isProject() const {
    const FileFormat *const found = format();
    return found != nullptr && found->kind == FileKind::Project;
}

std::string setParameters(Input &input, const std::map<std::string, std::string> &parameters) {
    input.options.parameters = parameters;
    return parameters.empty() || input.isProject() ? std::string() : "--set: only projects have parameters";
}

std::string checkDrawingOptions(const DrawingArguments &drawing, const Input &input, bool repairs) {
    const FileFormat *const format = input.format();
    if (format == nullptr) {
        return {}; // reading it says so
    }
    for (const auto &[option, word] : givenOptions(drawing, repairs)) {
        if (const std::string reason = reasonWithout(option, *format); !reason.empty()) {
            return word + ": " + reason + adviceOn(option);
        }
    }
    return {};
}

Diagnostics namePartsOf(const DrawingArguments &drawing, const Input &input, bool quiet, Domain &domain) {
    const FileFormat *const format = input.format();
    if (format != nullptr && format->kind == FileKind::Map) {
        return {};
    }
    Diagnostics remarks = nameParts(drawing.partNames, domain);
    if (!hasErrors(remarks) && quiet) {
        return {};
    }
    return allFormats().locateFaults(input.path, std::move(remarks), input.options);
}

Result<Input> openInput(const std::filesystem::path &path, const std::optional<std::string> &formatId) {
    Input input{path, {}};
    input.options.formatId = formatId.value_or("");
    if (isStandardStream(path)) {
        Result<std::string> bytes = readStandardInput(input.options.maxBytes);
        if (!bytes) {
            return bytes.faults();
        }
        input.path = "standard input";
        input.options.content = std::make_shared<const std::string>(std::move(*bytes));
        if (input.format() == nullptr) {
            Diagnostics fault = error("unknown-format", "cannot detect the format from the content",
                                      formatId ? "add --input-format with one of " + inputFormatIds()
                                               : std::string("give a file whose name has an extension"));
            fault.front().file = input.path.string();
            return fault;
        }
    }
    return input;
}

std::string inputFormatIds() {
    std::string list;
    for (const FileFormat &format : allFormats().list()) {
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
    const FileFormat *const format = allFormats().withId(formatId);
    const bool known = formatId.empty() || (format != nullptr && (format->readsDomain || format->readsMesh));
    if (known) {
        return {};
    }
    std::vector<std::string_view> ids;
    for (const FileFormat &each : allFormats().list()) {
        if (each.readsDomain || each.readsMesh) {
            ids.emplace_back(each.id);
        }
    }
    return "--input-format: unknown format '" + formatId + "'; expected one of " + inputFormatIds() +
           suggestion(formatId, ids);
}

std::string extensionList(bool (*accepts)(const FileFormat &)) {
    std::string list;
    for (const std::string &extension : allFormats().allExtensions(accepts)) {
        list += (list.empty() ? "" : ", ") + extension;
    }
    return list;
}

std::string meshFileHelp() {
    return "mesh file: " + extensionList([](const FileFormat &format) { return format.readsMesh; }) +
           "; -: standard input";
}

void printNotes(const ImportNotes &notes, bool quiet) {
    Diagnostics list = notes.diagnostics();
    if (quiet) {
        std::erase_if(list, [](const Diagnostic &note) { return note.severity == Severity::Note; });
    }
    printFaults(list);
}

} // namespace forefront
