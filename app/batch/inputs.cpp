#include "app/batch/inputs.hpp"

#include "app/batch/exit_code.hpp"
#include "app/batch/suggestion.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/source/source.hpp"

#include <algorithm>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns the names of the accepted formats, such as "GeoJSON and TopoJSON".
std::string formatNames(bool (*accepts)(const FileFormat &)) {
    std::vector<std::string> names;
    for (const FileFormat &format : allFormats().list()) {
        if (accepts(format)) {
            names.emplace_back(format.name);
        }
    }
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
    }
    return text;
}

std::string mapNames() {
    return formatNames([](const FileFormat &format) { return format.kind == FileKind::Map; });
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
    if (drawing.weldTolerance && !repairs && !format->arranges) {
        return "--weld: " + std::string(format->name) +
               " files are read unchanged; add --repair to join nearby nodes and segments";
    }
    const bool isMap = format->kind == FileKind::Map;
    if (drawing.layer && !format->hasLayers) {
        return "--layer: only " + formatNames([](const FileFormat &each) { return each.hasLayers; }) +
               " files have layers";
    }
    if (drawing.nameProperty && !isMap) {
        return "--name-property: only the features of " + mapNames() + " files have properties";
    }
    if (drawing.sizeProperty && !isMap) {
        return "--size-property: only the features of " + mapNames() + " files have properties";
    }
    if (!drawing.projection.empty() && !isMap) {
        return "--projection: only " + mapNames() + " files name a coordinate reference system";
    }
    if (drawing.overlap && !isMap) {
        return "--overlap: applies only to the polygons of " + mapNames() + " files";
    }
    if (drawing.degrees != DegreeRule::Warn && !isMap) {
        return std::string(drawing.degrees == DegreeRule::Local ? "--projection" : "--allow-degrees") + ": only " +
               mapNames() + " files have longitudes and latitudes";
    }
    if (!drawing.partNames.empty() && format->kind == FileKind::Project) {
        return "--name: a project keeps names of its own; name the segments in the editor, or by the command name of "
               "'forefront run'";
    }
    if (drawing.dropLines && !format->arranges) {
        return "--drop-lines: applies only to drawings and maps";
    }
    for (const auto &[given, option] :
         {std::pair(drawing.beyondPage, "--beyond-page"), std::pair(drawing.strokeAreas, "--stroke-areas"),
          std::pair(drawing.shapeRegions, "--shape-regions"), std::pair(drawing.whiteHoles == true, "--white-holes"),
          std::pair(drawing.whiteHoles == false, "--no-white-holes")}) {
        if (given && format->kind != FileKind::Drawing) {
            return std::string(option) + ": applies only to " +
                   formatNames([](const FileFormat &each) { return each.kind == FileKind::Drawing; }) + "s";
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
