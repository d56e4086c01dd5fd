#include "core/base/letter_case.hpp"
#include "core/io/abaqus/abaqus.hpp"
#include "core/io/esri/esri_grid.hpp"
#include "core/io/format.hpp"
#include "core/io/geojson/geojson.hpp"
#include "core/io/geojson/topojson.hpp"
#include "core/io/gmsh/gmsh.hpp"
#include "core/io/json/json_outline.hpp"
#include "core/io/medit/medit.hpp"
#include "core/io/netgen/netgen.hpp"
#include "core/io/obj/obj.hpp"
#include "core/io/png/png.hpp"
#include "core/io/project/project.hpp"
#include "core/io/su2/su2.hpp"
#include "core/io/svg/svg.hpp"
#include "core/io/triangle/triangle.hpp"
#include "core/io/vtk/vtk.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace forefront {

namespace {

// Every format with its name, its capabilities and its functions.
constexpr std::array kFormats = {
    Format{.about = {"project", "Forefront project", ".json", true, false, false},
           .otherExtensions = ".forefront",
           .recognise = looksLikeProject,
           .readDocument = readProjectText,
           .readSpacing = readProjectSpacing},
    Format{.about = {"geojson", "GeoJSON", ".geojson", true, false, false, true},
           .otherExtensions = ".json",
           .recognise = looksLikeGeoJson,
           .mayShowLate = true,
           .readDomain = readGeoJson},
    Format{.about = {"topojson", "TopoJSON", ".topojson", true, false, false, true},
           .otherExtensions = ".json",
           .recognise = looksLikeTopoJson,
           .mayShowLate = true,
           .readDomain = readTopoJson},
    Format{.about = {"poly", "Triangle domain", ".poly", true, false, false}, .readDomain = readPoly},
    Format{.about = {"svg", "SVG drawing", ".svg", true, false, true, true},
           .recognise = looksLikeSvg,
           .readDomain = readSvg,
           .writeMesh = writeSvg},
    Format{.about = {"msh2", "Gmsh MSH 2.2", ".msh", true, true, true},
           .recognise = looksLikeMsh,
           .readMesh = readMsh,
           .readSpacing = readMshSpacing,
           .readFields = readMshFields,
           .writeMesh = writeMsh2,
           .noteChanges = noteMshChanges},
    Format{.about = {"msh41", "Gmsh MSH 4.1", ".msh", true, true, true},
           .recognise = looksLikeMsh,
           .readMesh = readMsh,
           .readSpacing = readMshSpacing,
           .readFields = readMshFields,
           .writeMesh = writeMsh4,
           .noteChanges = noteMshChanges},
    Format{.about = {"msh41-binary", "Gmsh MSH 4.1, binary", ".msh", true, true, true},
           .recognise = looksLikeMsh,
           .readMesh = readMsh,
           .readSpacing = readMshSpacing,
           .readFields = readMshFields,
           .writeMesh = writeMsh4Binary,
           .noteChanges = noteMshChanges},
    Format{.about = {"vtu", "VTK unstructured grid", ".vtu", true, true, true},
           .recognise = looksLikeVtu,
           .readMesh = readVtu,
           .readFields = readVtuFields,
           .writeMesh = writeVtu},
    Format{.about = {"vtk", "VTK legacy", ".vtk", true, true, true},
           .recognise = looksLikeVtk,
           .readMesh = readVtk,
           .readFields = readVtkFields,
           .writeMesh = writeVtk},
    Format{.about = {"medit", "MEDIT", ".mesh", true, true, true},
           .recognise = looksLikeMedit,
           .readMesh = readMedit,
           .writeMesh = writeMedit},
    Format{.about = {"inp", "Abaqus and CalculiX", ".inp", true, true, true},
           .recognise = looksLikeAbaqus,
           .readMesh = readAbaqus,
           .writeMesh = writeAbaqus,
           .noteChanges = noteAbaqusChanges},
    Format{.about = {"su2", "SU2", ".su2", true, true, true, false, false},
           .recognise = looksLikeSu2,
           .readMesh = readSu2,
           .writeMesh = writeSu2,
           .noteChanges = noteSu2Changes},
    Format{.about = {"triangle", "Triangle .node/.ele/.edge", ".node", true, true, true},
           .otherExtensions = ".ele",
           .readMesh = readTriangle,
           .writeFiles = writeTriangle},
    Format{
        .about = {"netgen", "Netgen", ".vol", true, true, false}, .recognise = looksLikeNetgen, .readMesh = readNetgen},
    Format{.about = {"obj", "Wavefront OBJ", ".obj", true, true, true},
           .readMesh = readObj,
           .writeMesh = writeObj,
           .noteChanges = noteObjChanges},
    Format{.about = {"esri", "ESRI ASCII grid", ".asc", false, false, false},
           .recognise = looksLikeEsriGrid,
           .readSpacing = readEsriGrid},
    Format{.about = {"png", "PNG picture", ".png", false, false, false},
           .recognise = looksLikePng,
           .readSpacing = readPngSpacing},
};

std::string lowerExtension(const std::filesystem::path &path) {
    return lowerCase(path.extension().string());
}

bool hasExtension(const Format &format, const std::string &extension) {
    if (extension == format.about.extension) {
        return true;
    }
    const std::string others = std::string(" ") + format.otherExtensions + ' ';
    return extension.size() > 1 && others.find(' ' + extension + ' ') != std::string::npos;
}

} // namespace

std::span<const Format> formats() {
    return kFormats;
}

std::span<const FileFormat> fileFormats() {
    static constexpr auto kAbout = [] {
        std::array<FileFormat, kFormats.size()> list{};
        std::transform(kFormats.begin(), kFormats.end(), list.begin(), [](const Format &f) { return f.about; });
        return list;
    }();
    return kAbout;
}

std::vector<const FileFormat *> fileFormatsNamed(const std::filesystem::path &path) {
    const std::string extension = lowerExtension(path);
    std::vector<const FileFormat *> named;
    for (std::size_t i = 0; i < kFormats.size(); ++i) {
        if (hasExtension(kFormats[i], extension)) {
            named.push_back(&fileFormats()[i]);
        }
    }
    return named;
}

const Format *recognisedFormat(const std::filesystem::path &path, std::string_view head) {
    const std::string extension = lowerExtension(path);
    const Format *found = nullptr;
    for (const Format &format : kFormats) {
        if (format.recognise != nullptr && format.recognise(head)) {
            if (hasExtension(format, extension)) {
                return &format;
            }
            found = found == nullptr ? &format : found;
        }
    }
    return found;
}

const Format *formatOf(const std::filesystem::path &path, std::string_view content) {
    const std::string_view head = content.substr(0, kHeadBytes);
    if (const Format *const found = recognisedFormat(path, head)) {
        return found;
    }
    if (content.size() > head.size() && beginsAsObject(head)) {
        for (const Format &format : kFormats) {
            if (format.mayShowLate && format.recognise(content)) {
                return &format;
            }
        }
    }
    return formatOfExtension(path, [](const Format &) { return true; });
}

const Format *formatOfExtension(const std::filesystem::path &path, bool (*accepts)(const Format &)) {
    const std::string extension = lowerExtension(path);
    const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                    [&](const Format &f) { return hasExtension(f, extension) && accepts(f); });
    return found != kFormats.end() ? &*found : nullptr;
}

const Format *formatOfId(std::string_view id) {
    const auto found =
        std::find_if(kFormats.begin(), kFormats.end(), [&](const Format &f) { return id == f.about.id; });
    return found != kFormats.end() ? &*found : nullptr;
}

} // namespace forefront
