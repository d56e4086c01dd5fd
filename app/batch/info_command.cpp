#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/outputs.hpp"
#include "core/drawing/document/document.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/base/version.hpp"
#include "core/engine/domain/curved_bounds.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/mesh_extent.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/files/json/json_writer.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kInfoExamples = R"help(
A mesh that is not valid, as "forefront check" tells, is described without areas and lengths.

Examples:
  forefront info plate.msh
        elements of each kind, extent, area, regions and boundary parts, values, hash
  forefront info part.json --json
        segments, boundary parts and parameters of a project, for scripts

Exit codes: 0 done, 1 input refused (faults on stderr, one per line), 2 usage error.)help";

struct InfoArguments {
    std::filesystem::path file; ///< "-": standard input
    std::string inputFormat;
    bool json = false;
};

/// A part of a boundary, of a mesh or a domain.
struct NamedPart {
    std::int32_t tag = 1;
    std::string name; ///< its own, else its default name
    std::size_t count = 0;
    std::optional<double> measure; ///< length or area
};

std::string shortNumber(double value) {
    constexpr int kDigits = 8;
    return numberText(value, kDigits);
}

/// The description of a file.
struct FileInfo {
    std::string format, formatName, kind;
    Box2 bounds;
    std::vector<std::pair<std::string, std::size_t>> counts; ///< by key, in order; counts of 0 are left out of the text
    std::optional<double> area;
    std::vector<NamedPart> boundaries, regions;
    const char *boundaryUnit = "edge", *regionUnit = "element";
    std::vector<std::string> nodeValues, elementValues;
    std::vector<std::pair<Parameter, ParameterState>> parameters;
    std::optional<bool> valid;
    std::string hash;
    LengthUnit unit = LengthUnit::None; ///< of the coordinates
};

/// Adds what sets a valid mesh of second order apart: how many nodes are corners, and how many edges are curved.
void countSecondOrder(const MeshView &mesh, FileInfo &info) {
    if (!mesh.hasSecondOrder()) {
        return;
    }
    std::vector<bool> isCorner(mesh.nodes.size(), false);
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        for (const NodeId corner : mesh.cornersOf(e)) {
            isCorner[index(corner)] = true;
        }
    }
    const auto isCurved = [&](const TaggedEdge &edge) {
        const auto at = [&](NodeId node) { return mesh.nodes[index(node)]; };
        return edge.middle != kNoNode && !isMiddleOfChord(at(edge.a), at(edge.b), at(edge.middle));
    };
    info.counts.emplace_back("nodes at corners", std::ranges::count(isCorner, true));
    info.counts.emplace_back("curved edges", std::ranges::count_if(mesh.edges, isCurved));
}

void describeMesh(const MeshFields &file, FileInfo &info) {
    const MeshView mesh(file.mesh);
    info.kind = "mesh";
    info.bounds = mesh.bounds();
    info.counts = {{"nodes", mesh.nodes.size()}, {"elements", mesh.elementCount()}};
    for (const MeshView::Block &block : mesh.blocks()) {
        info.counts.emplace_back(block.traits().plural, block.size());
    }
    info.counts.emplace_back("tagged edges", mesh.edges.size());
    info.counts.emplace_back("tagged points", mesh.points.size());
    info.valid = mesh.elementCount() > 0 && !hasErrors(verify(mesh, 1));
    if (*info.valid) {
        const MeshExtent extent = extentOf(mesh, edgesOf(mesh).edges.size());
        info.counts.emplace_back("parts", extent.parts);
        info.counts.emplace_back("holes", extent.holes);
        countSecondOrder(mesh, info);
        info.area = 0.0;
        for (const RegionExtent &region : extent.regions) {
            *info.area += region.area;
            info.regions.push_back(
                {region.tag, regionName(mesh.regionNames, region.tag), region.elements, region.area});
        }
        for (const BoundaryExtent &part : extent.boundaries) {
            info.boundaries.push_back({part.tag, boundaryName(mesh.boundaryNames, part.tag), part.edges, part.length});
        }
    }
    for (const auto &[name, values] : file.fields) {
        info.nodeValues.push_back(name);
    }
    for (const auto &[name, values] : file.elementFields) {
        info.elementValues.push_back(name);
    }
    info.hash = toHex(meshHash(mesh));
}

double lengthOf(const Domain &domain, const DomainSegment &segment) {
    return segment.stretch.follows()
               ? domain.curves[segment.stretch.curve].length(std::min(segment.stretch.t0, segment.stretch.t1),
                                                             std::max(segment.stretch.t0, segment.stretch.t1))
               : distance(domain.nodes[segment.a], domain.nodes[segment.b]);
}

void describeDomain(const Domain &domain, FileInfo &info) {
    info.kind = "domain";
    info.bounds = curvedBounds(domain);
    info.counts = {{"nodes", domain.nodes.size()},
                   {"segments", domain.segments.size()},
                   {"curves", domain.curves.size()},
                   {"points", domain.points.size()},
                   {"hole markers", domain.holeMarkers.size()},
                   {"region markers", domain.regionMarkers.size()}};
    info.boundaryUnit = "segment";
    std::map<std::int32_t, NamedPart> parts;
    for (const DomainSegment &segment : domain.segments) {
        NamedPart &part = parts[segment.tag];
        part = {segment.tag, boundaryName(domain.boundaryNames, segment.tag), part.count + 1,
                part.measure.value_or(0.0) + lengthOf(domain, segment)};
    }
    for (auto &[tag, part] : parts) {
        info.boundaries.push_back(std::move(part));
    }
    info.regionUnit = "marker";
    std::map<std::int32_t, NamedPart> regions;
    for (const RegionMarker &marker : domain.regionMarkers) {
        NamedPart &region = regions[marker.tag];
        region = {marker.tag, regionName(domain.regionNames, marker.tag), region.count + 1, {}};
    }
    for (auto &[tag, region] : regions) {
        info.regions.push_back(std::move(region));
    }
}

std::string partLine(const NamedPart &part, const char *unit, const char *measure) {
    const std::string line =
        "  " + part.name + ": tag " + std::to_string(part.tag) + ", " + countText(part.count, unit);
    return line + (part.measure ? std::string(", ") + measure + ' ' + shortNumber(*part.measure) : "") + '\n';
}

std::string listLine(const char *title, const std::vector<std::string> &words) {
    std::string line;
    for (const std::string &word : words) {
        line += (line.empty() ? "" : ", ") + word;
    }
    return words.empty() ? std::string() : std::string(title) + ": " + line + '\n';
}

std::string infoText(const InfoArguments &arguments, const FileInfo &info) {
    std::string text = arguments.file.string() + ": " + info.kind + ", " + info.formatName + '\n';
    for (const auto &[key, count] : info.counts) {
        text += count > 0 ? key + ": " + std::to_string(count) + '\n' : "";
    }
    text += "bounds: (" + shortNumber(info.bounds.min.x) + ", " + shortNumber(info.bounds.min.y) + ") to (" +
            shortNumber(info.bounds.max.x) + ", " + shortNumber(info.bounds.max.y) + ")\n";
    text += info.unit != LengthUnit::None ? "unit: " + std::string(wordOf(info.unit)) + '\n' : "";
    text += info.area ? "area: " + shortNumber(*info.area) + '\n' : "";
    text += info.regions.empty() ? "" : "regions:\n";
    for (const NamedPart &region : info.regions) {
        text += partLine(region, info.regionUnit, "area");
    }
    text += info.boundaries.empty() ? "" : "boundary parts:\n";
    for (const NamedPart &part : info.boundaries) {
        text += partLine(part, info.boundaryUnit, "length");
    }
    text += listLine("values of nodes", info.nodeValues) + listLine("values of elements", info.elementValues);
    text += info.parameters.empty() ? "" : "parameters:\n";
    for (const auto &[parameter, state] : info.parameters) {
        text += "  " + parameter.name + " = " + parameter.expression +
                (!state.value                                        ? " (" + state.fault + ')'
                 : shortNumber(*state.value) == parameter.expression ? ""
                                                                     : " = " + shortNumber(*state.value)) +
                '\n';
    }
    text += info.valid && !*info.valid ? "not valid; forefront check tells why\n" : "";
    return text + (info.hash.empty() ? "" : "hash: " + info.hash + '\n');
}

void addParts(JsonWriter &json, const std::vector<NamedPart> &parts, const char *count, const char *measure) {
    json.beginArray();
    for (const NamedPart &part : parts) {
        json.beginObject().member("tag", part.tag).member("name", part.name).member(count, part.count);
        if (part.measure) {
            json.member(measure, *part.measure);
        }
        json.endObject();
    }
    json.endArray();
}

/// Returns a key of JSON: words joined by underscores.
std::string keyOf(std::string words) {
    std::replace(words.begin(), words.end(), ' ', '_');
    return words;
}

std::string infoJson(const InfoArguments &arguments, const FileInfo &info) {
    JsonWriter json(JsonWriter::Layout::Indented);
    json.beginObject().member("version", version()).member("file", arguments.file.string());
    json.member("kind", info.kind).member("format", info.format);
    json.key("bounds").values(
        std::vector<double>{info.bounds.min.x, info.bounds.min.y, info.bounds.max.x, info.bounds.max.y});
    if (info.unit != LengthUnit::None) {
        json.member("unit", wordOf(info.unit));
    }
    for (const auto &[key, count] : info.counts) {
        json.member(keyOf(key), count);
    }
    if (info.area) {
        json.member("area", *info.area);
    }
    json.key("regions");
    addParts(json, info.regions, keyOf(std::string(info.regionUnit) + 's').c_str(), "area");
    json.key("boundaries");
    addParts(json, info.boundaries, keyOf(std::string(info.boundaryUnit) + 's').c_str(), "length");
    if (info.kind == "mesh") {
        json.key("node_values").values(info.nodeValues);
        json.key("element_values").values(info.elementValues);
        json.member("valid", info.valid.value_or(false)).member("hash", info.hash);
    }
    if (!info.parameters.empty()) {
        json.key("parameters").beginObject();
        for (const auto &[parameter, state] : info.parameters) {
            json.key(parameter.name).beginObject().member("expression", parameter.expression);
            json.key("value").value(state.value.value_or(std::numeric_limits<double>::quiet_NaN())).endObject();
        }
        json.endObject();
    }
    return json.endObject().text();
}

/// Fills in what the file holds. Returns its faults.
Diagnostics describe(const Input &input, const FileFormat &format, FileInfo &info, ImportNotes &notes) {
    if (format.readsMesh) {
        const Result<MeshFields> mesh = allFormats().readFields(input.path, input.options, &notes);
        if (mesh) {
            describeMesh(*mesh, info);
        }
        return mesh ? Diagnostics{} : mesh.faults();
    }
    if (!format.readsDomain) {
        const std::string files = std::string(format.name) + " files ";
        const Diagnostics fault =
            format.readsSpacing
                ? error("no-content", files + "hold neither a mesh nor a domain", "use them as --spacing-file")
                : error("no-content", files + "are written, but cannot be read back");
        return allFormats().locateFaults(input.path, fault, input.options);
    }
    if (format.kind == FileKind::Project) {
        const Result<Document> project = readDocument(input.path, input.options, &notes);
        if (!project) {
            return project.faults();
        }
        const std::vector<ParameterState> states = parameterStates(project->parameters);
        for (std::size_t k = 0; k < states.size(); ++k) {
            info.parameters.emplace_back(project->parameters[k], states[k]);
        }
    }
    const Result<DomainFile> file =
        allFormats().readDomain(input.path, input.options, format.kind == FileKind::Project ? nullptr : &notes);
    if (!file) {
        return file.faults();
    }
    describeDomain(file->domain, info);
    info.unit = file->unit;
    return {};
}

} // namespace

int infoCommand(const CommandLine &line) {
    InfoArguments arguments;
    CLI::App app("Tells what a mesh, domain or project file holds.", "forefront info");
    app.footer(kInfoExamples);
    app.add_option("FILE", arguments.file, "mesh, domain or project; -: standard input")->required();
    addInputFormatOption(app, "FILE", arguments.inputFormat);
    app.add_flag("--json", arguments.json, "print JSON");
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    if (const std::string wrong = checkInputs({arguments.file}, arguments.inputFormat); !wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    const Result<Input> input = openInput(arguments.file, arguments.inputFormat);
    if (!input) {
        printFaults(input.faults());
        return kRefused;
    }
    const FileFormat *const format = input->format();
    FileInfo info;
    ImportNotes notes;
    Diagnostics faults;
    if (format == nullptr) {
        faults = allFormats().readDomain(input->path, input->options).faults(); // tells why it cannot be read
    } else {
        info.format = format->id;
        info.formatName = format->name;
        faults = describe(*input, *format, info, notes);
    }
    if (faults.empty()) {
        printNotes(notes, false);
        faults = printText(arguments.json ? infoJson(arguments, info) : infoText(arguments, info));
    }
    printFaults(faults);
    return faults.empty() ? kDone : kRefused;
}

} // namespace forefront
