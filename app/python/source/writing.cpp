#include "app/python/source/writing.hpp"

#include "app/python/source/arrays.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/progress_calls.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/numbering.hpp"
#include "core/files/common/tagged_sides.hpp"
#include "core/files/common/usual_extrusion.hpp"
#include "core/files/elevations.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"
#include "core/files/open_boundaries.hpp"
#include "core/files/text/text_writer.hpp"

#include <cmath>
#include <filesystem>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <vector>

namespace forefront::python {

namespace {

/// How a mesh is written: the arguments of Mesh.write().
struct Writing {
    std::filesystem::path path; ///< empty: to memory
    std::string format;         ///< id; empty: by the extension
    std::optional<bool> innerEdges{};
    Numbering numbering = Numbering::Creation;
    std::vector<double> elevations{}; ///< of the nodes in the order of creation; empty: none
    ExportOptions options{};
    bool unitGiven = false;
};

/// Returns the format of a file; null if it is unknown, which writing reports.
const FileFormat *formatOf(const Writing &how) {
    if (!how.format.empty()) {
        return allFormats().withId(how.format);
    }
    for (const FileFormat *const format : allFormats().withExtensionOf(how.path)) {
        if (format->writesMesh) {
            return format;
        }
    }
    return nullptr;
}

/// Refuses an argument that the format has no place for. `lacks`: what its files do not do.
void refuseUnless(bool FileFormat::*trait, const FileFormat &format, const char *argument, const char *lacks) {
    if (format.*trait) {
        return;
    }
    std::string others;
    for (const FileFormat &other : allFormats().list()) {
        if (other.writesMesh && other.*trait) {
            others += (others.empty() ? "" : ", ") + std::string(other.id);
        }
    }
    throw py::value_error(std::string(argument) + ": " + format.name + " files " + lacks +
                          "; write one of the formats " + others);
}

void refuseUnused(const Writing &how) {
    const FileFormat *const format = formatOf(how);
    if (format == nullptr) {
        return;
    }
    if (!how.elevations.empty()) {
        refuseUnless(&FileFormat::holdsElevations, *format, "elevation", "hold no elevations");
    }
    if (how.options.extrusion) {
        refuseUnless(&FileFormat::holdsSolids, *format, "extrude", "hold no prisms and hexahedra");
    }
    if (!how.options.openBoundaries.empty()) {
        refuseUnless(&FileFormat::hasOpenBoundaries, *format, "open", "do not tell open boundaries from land");
    }
    if (how.options.keepTags) {
        refuseUnless(&FileFormat::tellsTagsApart, *format, "tags", "do not number tags apart");
    }
    if (how.unitGiven) {
        refuseUnless(&FileFormat::namesUnit, *format, "unit", "name no unit");
    }
    if (how.options.keepTags && how.options.extrusion) {
        throw py::value_error("tags: extruded meshes have faces and volumes, which are numbered apart; leave out "
                              "tags='keep'");
    }
}

/// Refuses tags of parts that are not on the boundary.
void checkOpenTags(const Mesh &mesh, const std::vector<std::int32_t> &tags) {
    if (tags.empty()) {
        return;
    }
    const TaggedSides sides(mesh);
    for (const std::int32_t tag : tags) {
        bool outer = false;
        for (std::size_t k = 0; k < mesh.edges.size() && !outer; ++k) {
            outer = mesh.edges[k].tag == tag && sides.of(k).size() == 1;
        }
        if (!outer) {
            throw py::value_error("open: no part of the boundary has the tag " + std::to_string(tag));
        }
    }
}

Extrusion extrusionOf(double height, std::int64_t layers) {
    if (!(std::isfinite(height) && height > 0.0) || layers < 1 || layers > kMaxExtrudedLayers) {
        throw py::value_error("extrude: expected a height above 0, or (height, layers) with 1 to " +
                              std::to_string(kMaxExtrudedLayers) + " layers");
    }
    return {height, static_cast<std::uint32_t>(layers)};
}

template <class Enum>
Enum wordArgument(const char *argument, const std::string &word) {
    const std::optional<Enum> known = fromWord<Enum>(word);
    if (!known) {
        throw py::value_error(std::string(argument) + ": expected " + wordList<Enum>() + ", got '" + word + "'");
    }
    return *known;
}

std::vector<double> elevationsOfNodes(const PythonMesh &self, const py::handle &given) {
    if (given.is_none()) {
        return {};
    }
    const auto array = given.cast<ArrayOf<double>>();
    const std::size_t nodes = self.mesh->nodes.size();
    if (array.ndim() != 1 || static_cast<std::size_t>(array.size()) != nodes) {
        throw py::value_error("elevation: expected one for each of the " + std::to_string(nodes) + " nodes, got " +
                              std::to_string(array.size()));
    }
    std::vector<double> values(array.data(), array.data() + array.size());
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (!std::isfinite(values[n])) {
            throw py::value_error("elevation: expected finite numbers, got " + numberText(values[n], 4) + " at node " +
                                  std::to_string(n));
        }
    }
    return values;
}

Writing writingOf(const PythonMesh &self, std::filesystem::path path, const std::string &format,
                  const py::dict &given) {
    Writing how{std::move(path), format, given["inner_edges"].cast<std::optional<bool>>()};
    how.numbering = wordArgument<Numbering>("numbering", given["numbering"].cast<std::string>());
    how.elevations = elevationsOfNodes(self, given["elevation"]);
    how.options.openBoundaries = given["open"].cast<std::vector<std::int32_t>>();
    if (const py::object extrude = given["extrude"]; !extrude.is_none()) {
        const auto [height, layers] = extrude.cast<std::pair<double, std::int64_t>>();
        how.options.extrusion = extrusionOf(height, layers);
    }
    const auto tags = given["tags"].cast<std::string>();
    if (tags != "apart" && tags != "keep") {
        throw py::value_error("tags: expected apart or keep, got '" + tags + "'");
    }
    how.options.keepTags = tags == "keep";
    how.unitGiven = !given["unit"].is_none();
    how.options.unit = how.unitGiven ? wordArgument<LengthUnit>("unit", given["unit"].cast<std::string>()) : self.unit;
    how.options.system = self.system;
    refuseUnused(how);
    checkOpenTags(*self.mesh, how.options.openBoundaries);
    return how;
}

/// A mesh as a file gets it.
struct FormedMesh {
    const Mesh &given;
    std::optional<Mesh> outline;  ///< without inner edges
    std::optional<Mesh> numbered; ///< with other numbers
    std::vector<double> elevations;

    MeshView view() const {
        MeshView mesh = numbered ? *numbered : outline ? *outline : given;
        mesh.elevations = elevations;
        return mesh;
    }
};

FormedMesh formedMesh(const Mesh &mesh, const Writing &how) {
    FormedMesh formed{mesh, {}, {}, how.elevations};
    const bool drops = how.innerEdges ? !*how.innerEdges : !acceptsInnerEdges(how.path, how.format);
    if (drops && hasInnerEdges(mesh)) {
        formed.outline = withoutInnerEdges(mesh);
    }
    if (how.numbering == Numbering::ReverseCuthillMcKee) {
        const std::vector<NodeId> numbers = reverseCuthillMcKee(mesh);
        formed.numbered = renumbered(formed.view(), numbers);
        formed.elevations = renumberedElevations(how.elevations, numbers);
    }
    return formed;
}

/// Returns notes on what the file has otherwise than the mesh.
Diagnostics notesOn(const FormedMesh &formed, const Writing &how) {
    const MeshView mesh = formed.view();
    Diagnostics notes = exportNotes(how.path, mesh, how.format, how.options);
    const auto add = [&](const char *code, const std::string &message) {
        Diagnostic note = noteOf(code, message);
        note.file = how.path.string();
        notes.push_back(std::move(note));
    };
    for (Diagnostic &note : noteAllLand(how.path, how.format, how.options, "open=[name] opens a part")) {
        notes.push_back(std::move(note));
    }
    if (!how.options.extrusion && solidsOnly(how.path, how.format)) {
        add("thickness", "the mesh is one cell thick, " + numberText(usualExtrusion(mesh).height, 4) +
                             " as the elements are wide; extrude=height sets the thickness");
    }
    if (const std::size_t left = formed.given.edges.size() - mesh.edges.size(); !how.innerEdges && left > 0) {
        add("inner-edges", "left out " + countText(left, "tagged edge") +
                               " inside the domain: in this format, every tagged edge is a boundary; "
                               "inner_edges=True writes " +
                               (left == 1 ? "it" : "them"));
    }
    return notes;
}

py::list writeFile(const PythonMesh &self, const std::filesystem::path &path, const std::string &format,
                   const py::dict &given, const py::object &callback) {
    const Writing how = writingOf(self, path, format, given);
    const Progress progress = progressOf(callback);
    const Diagnostics notes = withoutGil([&] {
        const FormedMesh formed = formedMesh(*self.mesh, how);
        const Status written = writeMesh(how.path, formed.view(), how.format, progress, how.options);
        return hasErrors(written) ? written : notesOn(formed, how);
    });
    raiseErrors(notes);
    return faultList(notes);
}

/// Returns the bytes of a file, and notes on it.
py::tuple toBytes(const PythonMesh &self, const std::string &format, const py::dict &given) {
    const Writing how = writingOf(self, {}, format, given);
    StringSink sink;
    const Diagnostics notes = withoutGil([&] {
        const FormedMesh formed = formedMesh(*self.mesh, how);
        const Status written = writeMesh(sink, formed.view(), how.format, how.options);
        return hasErrors(written) ? written : notesOn(formed, how);
    });
    raiseErrors(notes);
    return py::make_tuple(py::bytes(sink.text), faultList(notes));
}

/// Returns the values of a raster at the nodes, and the notes of its reader.
py::tuple rasterElevations(const PythonMesh &self, const std::filesystem::path &path) {
    ImportNotes notes;
    const std::vector<double> values = valueOrRaise(withoutGil([&]() -> Result<std::vector<double>> {
        const Result<Raster> raster = readRaster(path, {}, &notes);
        if (!raster) {
            return raster.faults();
        }
        Result<std::vector<double>> found = elevationsOf(*self.mesh, *raster);
        if (found) {
            return found;
        }
        Diagnostics faults = found.faults();
        for (Diagnostic &fault : faults) {
            fault.file = path.string();
        }
        return faults;
    }));
    return py::make_tuple(copyOfValues<double>(values), faultList(notes.diagnostics()));
}

py::array expressionElevations(const PythonMesh &self, const std::string &expression) {
    return copyOfValues<double>(valueOrRaise(withoutGil([&] { return elevationsOf(*self.mesh, expression); })));
}

} // namespace

void bindWriting(py::class_<PythonMesh> &mesh) {
    mesh.def("_write", &writeFile)
        .def("_to_bytes", &toBytes)
        .def("_raster_elevations", &rasterElevations)
        .def("_expression_elevations", &expressionElevations);
}

} // namespace forefront::python
