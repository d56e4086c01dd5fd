#include "core/files/openfoam/openfoam.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/common/usual_extrusion.hpp"
#include "core/files/openfoam/foam_faces.hpp"

#include <string>
#include <system_error>
#include <vector>

namespace forefront {

namespace {

/// A patch: faces that follow each other.
struct Patch {
    std::string name;
    const char *type;
    std::size_t count, first;
};

/// The names of patches and zones.
FileNames foamNames(const TagList &tags, UniqueNames &unique) {
    unique.claim("frontAndBack");
    unique.claim("defaultFaces");
    return identifiersOf(tags, unique);
}

void writeFoamHeader(const char *kind, const char *object, TextWriter &out, const std::string &note = {}) {
    out << "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       " << kind << ";\n";
    if (!note.empty()) {
        out << "    note        \"" << note << "\";\n";
    }
    out << "    location    \"constant/polyMesh\";\n    object      " << object << ";\n}\n\n";
}

/// Writes a list of numbers with its length.
template <class List, class Number>
void writeFoamList(const List &list, Number number, TextWriter &out) {
    out << list.size() << "\n(\n";
    for (std::size_t k = 0; k < list.size() && out.ok(); ++k) {
        out << number(list[k]) << '\n';
    }
    out << ")\n";
}

class FoamCase {
  public:
    FoamCase(const MeshView &mesh, const Extrusion &extrusion, FoamFaces faces)
        : mesh_(mesh), extrusion_(extrusion), faces_(std::move(faces)), names_(foamNames(tagsOf(mesh), unique_)) {
        for (auto &[tag, part] : faces_.parts) {
            addPatch(names_.edges.at(tag), "patch", part);
        }
        addPatch("defaultFaces", "patch", faces_.untagged);
        if (extrusion.layers == 1) {
            faces_.back.insert(faces_.back.end(), faces_.front.begin(), faces_.front.end());
            addPatch("frontAndBack", "empty", faces_.back);
        } else {
            addPatch(unique_.claim("back"), "patch", faces_.back);
            addPatch(unique_.claim("front"), "patch", faces_.front);
        }
    }

    void writePoints(TextWriter &out) const {
        writeFoamHeader("vectorField", "points", out);
        const std::uint32_t layers = extrusion_.layers;
        out << mesh_.nodes.size() * (layers + 1) << "\n(\n";
        for (std::size_t n = 0; n < mesh_.nodes.size() && out.ok(); ++n) {
            for (std::uint32_t k = 0; k <= layers; ++k) {
                const double z = k == layers ? extrusion_.height : extrusion_.height * k / layers;
                out << '(' << mesh_.nodes[n].x << ' ' << mesh_.nodes[n].y << ' ' << z << ")\n";
            }
        }
        out << ")\n";
    }

    void writeFaces(TextWriter &out) const {
        writeFoamHeader("faceList", "faces", out);
        out << faces_.faces.size() << "\n(\n";
        for (std::size_t k = 0; k < faces_.faces.size() && out.ok(); ++k) {
            const FoamFace &face = faces_.faces[k];
            out << std::uint32_t{face.count} << '(';
            for (std::size_t c = 0; c < face.count; ++c) {
                out << (c == 0 ? "" : " ") << face.corners[c];
            }
            out << ")\n";
        }
        out << ")\n";
    }

    void writeOwners(TextWriter &out) const {
        writeFoamHeader("labelList", "owner", out, counts());
        writeFoamList(
            faces_.faces, [](const FoamFace &face) { return face.owner; }, out);
    }

    void writeNeighbours(TextWriter &out) const {
        writeFoamHeader("labelList", "neighbour", out, counts());
        writeFoamList(
            std::span(faces_.faces).first(faces_.inner), [](const FoamFace &face) { return face.neighbour; }, out);
    }

    void writeBoundary(TextWriter &out) const {
        writeFoamHeader("polyBoundaryMesh", "boundary", out);
        out << patches_.size() << "\n(\n";
        for (const Patch &patch : patches_) {
            out << "    " << patch.name << "\n    {\n        type            " << patch.type
                << ";\n        nFaces          " << patch.count << ";\n        startFace       " << patch.first
                << ";\n    }\n";
        }
        out << ")\n";
    }

    void writeCellZones(TextWriter &out) const {
        writeFoamHeader("regIOobject", "cellZones", out);
        const PartsByTag regions = elementsByRegion(mesh_);
        out << regions.size() << "\n(\n";
        for (const auto &[tag, elements] : regions) {
            out << names_.regions.at(tag) << "\n{\n    type cellZone;\n    cellLabels List<label>\n"
                << elements.size() * extrusion_.layers << "\n(\n";
            for (std::size_t k = 0; k < elements.size() && out.ok(); ++k) {
                for (std::uint32_t layer = 0; layer < extrusion_.layers; ++layer) {
                    out << std::uint64_t{elements[k]} * extrusion_.layers + layer << '\n';
                }
            }
            out << ");\n}\n";
        }
        out << ")\n";
    }

    void writeFaceZones(TextWriter &out) const {
        writeFoamHeader("regIOobject", "faceZones", out);
        out << faces_.zones.size() << "\n(\n";
        for (const auto &[tag, zone] : faces_.zones) {
            out << zoneName(tag) << "\n{\n    type faceZone;\n    faceLabels List<label>\n";
            writeFoamList(
                zone.faces, [](std::size_t face) { return face; }, out);
            out << ";\n    flipMap List<bool>\n";
            writeFoamList(
                zone.flipped, [](bool flipped) { return flipped ? '1' : '0'; }, out);
            out << ";\n}\n";
        }
        out << ")\n";
    }

  private:
    void addPatch(const std::string &name, const char *type, const std::vector<FoamFace> &faces) {
        if (!faces.empty()) {
            patches_.push_back({name, type, faces.size(), faces_.faces.size()});
            faces_.faces.insert(faces_.faces.end(), faces.begin(), faces.end());
        }
    }

    const std::string &zoneName(std::int32_t tag) const { return names_.edges.at(tag); }

    /// Returns the numbers that OpenFOAM's programs write into a header.
    std::string counts() const {
        return "nPoints:" + std::to_string(mesh_.nodes.size() * (extrusion_.layers + 1)) +
               " nCells:" + std::to_string(mesh_.elementCount() * extrusion_.layers) +
               " nFaces:" + std::to_string(faces_.faces.size()) + " nInternalFaces:" + std::to_string(faces_.inner);
    }

    const MeshView &mesh_;
    Extrusion extrusion_;
    FoamFaces faces_;
    UniqueNames unique_;
    FileNames names_;
    std::vector<Patch> patches_;
};

/// Returns the fault of a folder with files of another mesh that OpenFOAM reads besides those that are written.
Status checkFoamFolder(const std::filesystem::path &folder) {
    std::vector<std::string> others = {"pointZones", "pointZones.gz"};
    for (const char *file : kFoamFiles) {
        others.push_back(std::filesystem::path(file).filename().string() + ".gz");
    }
    for (const std::string &name : others) {
        const std::filesystem::path file = folder / "constant/polyMesh" / name;
        std::error_code none;
        if (std::filesystem::exists(file, none)) {
            return error("cannot-write",
                         "the folder holds a file of another mesh, which OpenFOAM would read, too: " + file.string(),
                         "remove it, or choose another name");
        }
    }
    return {};
}

} // namespace

Status writeOpenFoam(FileSet &files, const std::filesystem::path &folder, const MeshView &mesh,
                     const ExportOptions &options, const Progress &progress) {
    if (Status other = checkFoamFolder(folder); !other.empty()) {
        return other;
    }
    const Extrusion extrusion = options.extrusion.value_or(usualExtrusion(mesh));
    Result<FoamFaces> faces = foamFaces(mesh, extrusion.layers);
    if (!faces) {
        return faces.faults();
    }
    const FoamCase foam(mesh, extrusion, std::move(*faces));
    using Write = void (FoamCase::*)(TextWriter &) const;
    constexpr std::array<Write, kFoamFiles.size() - 1> kWrites{
        &FoamCase::writePoints,   &FoamCase::writeFaces,     &FoamCase::writeOwners,   &FoamCase::writeNeighbours,
        &FoamCase::writeBoundary, &FoamCase::writeCellZones, &FoamCase::writeFaceZones};
    files.makeFolder(folder / "constant/polyMesh");
    for (std::size_t k = 0; k < kWrites.size(); ++k) {
        files.write(
            folder / kFoamFiles[k], [&](TextWriter &out) { (foam.*kWrites[k])(out); }, progress);
    }
    files.write(folder / kFoamFiles.back(), std::string_view());
    return files.status();
}

Diagnostics noteOpenFoamChanges(const MeshView &mesh) {
    UniqueNames unique;
    TagList tags = tagsOf(mesh);
    tags.points.clear();
    Diagnostics notes = noteChangedNames(tags, foamNames(tags, unique));
    if (!mesh.periodic.empty()) {
        Diagnostic &note = notes.emplace_back();
        note.severity = Severity::Note;
        note.code = "periodic";
        note.message = "periodic parts are plain patches, whose faces fit each other";
        note.advice = "make cyclic patches of them with createPatch";
    }
    return notes;
}

} // namespace forefront
