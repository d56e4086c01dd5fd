#include "app/python/source/reading.hpp"

#include "app/python/source/arrays.hpp"
#include "app/python/source/domain.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/mesh.hpp"
#include "app/python/source/progress_calls.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/reader_options.hpp"
#include "core/files/files.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>

namespace forefront::python {

namespace {

/// A path, or bytes with the id of their format.
struct PythonFile {
    std::filesystem::path path;
    ImportOptions options;
};

PythonFile fileOf(const py::object &source, const std::string &format) {
    PythonFile file;
    file.options.formatId = format;
    if (!format.empty() && allFormats().withId(format) == nullptr) {
        throw py::value_error("format: unknown format '" + format + "'; see formats()");
    }
    if (py::isinstance<py::bytes>(source)) {
        file.options.content = std::make_shared<const std::string>(source.cast<std::string>());
        file.path = "<memory>";
    } else {
        file.path = source.cast<std::filesystem::path>();
    }
    return file;
}

/// Takes options of readers from keyword arguments.
void setImportOptions(ImportOptions &options, const py::dict &given) {
    for (const auto &[key, value] : given) {
        const auto name = key.cast<std::string>();
        if (name == "curve_tolerance") {
            options.curveTolerance = value.cast<double>();
        } else if (name == "weld") {
            options.weldTolerance = value.cast<double>();
        } else if (name == "layer") {
            options.layer = value.cast<std::string>();
        } else if (name == "names") {
            options.nameProperty = value.cast<std::string>();
        } else if (name == "sizes") {
            options.sizeProperty = value.cast<std::string>();
        } else if (name == "projection") {
            options.projection = value.cast<std::string>();
        } else if (name == "overlap") {
            const auto word = value.cast<std::string>();
            const std::optional<OverlapRule> rule = fromWord<OverlapRule>(word);
            if (!rule) {
                throw py::value_error("overlap: expected " + wordList<OverlapRule>() + ", got '" + word + "'");
            }
            options.overlap = *rule;
        } else if (name == "strict") {
            options.strict = value.cast<bool>();
        } else if (name == "beyond_page") {
            options.beyondPage = value.cast<bool>();
        } else if (name == "drop_lines") {
            options.dropLines = value.cast<bool>();
        } else if (name == "stroke_areas") {
            options.strokeAreas = value.cast<bool>();
        } else if (name == "shape_regions") {
            options.shapeRegions = value.cast<bool>();
        } else if (name == "white_holes") {
            options.whiteHoles = value.cast<bool>();
        } else if (name == "degrees") {
            const auto word = value.cast<std::string>();
            if (word != "warn" && word != "keep" && word != "local") {
                throw py::value_error("degrees: expected warn, keep or local, got '" + word + "'");
            }
            options.degrees = word == "warn" ? DegreeRule::Warn : word == "keep" ? DegreeRule::Keep : DegreeRule::Local;
        } else if (name == "parts") {
            for (const auto &[part, places] :
                 value.cast<std::map<std::string, std::array<std::array<double, 2>, 2>>>()) {
                const auto &[from, to] = places;
                options.partNames.push_back({part, {from[0], from[1]}, {to[0], to[1]}});
            }
        } else if (name == "parameters") {
            options.parameters = value.cast<std::map<std::string, std::string>>();
        } else {
            throw py::type_error("unknown option '" + name + "' of a reader");
        }
    }
}

/// The options of readers that not every format has, by their keywords.
constexpr std::array kReaderOptions = {
    std::pair("curve_tolerance", ReaderOption::CurveTolerance),
    std::pair("weld", ReaderOption::Weld),
    std::pair("layer", ReaderOption::Layer),
    std::pair("names", ReaderOption::NameProperty),
    std::pair("sizes", ReaderOption::SizeProperty),
    std::pair("projection", ReaderOption::Projection),
    std::pair("overlap", ReaderOption::Overlap),
    std::pair("beyond_page", ReaderOption::BeyondPage),
    std::pair("drop_lines", ReaderOption::DropLines),
    std::pair("stroke_areas", ReaderOption::StrokeAreas),
    std::pair("shape_regions", ReaderOption::ShapeRegions),
    std::pair("white_holes", ReaderOption::WhiteHoles),
    std::pair("degrees", ReaderOption::Degrees),
    std::pair("parts", ReaderOption::PartNames),
    std::pair("parameters", ReaderOption::Parameters),
};

/// Refuses options that the reader of a format would ignore.
void refuseOptionsWithout(const FileFormat &format, const py::dict &given) {
    for (const auto &[name, option] : kReaderOptions) {
        const std::string reason = given.contains(name) ? reasonWithout(option, format) : std::string();
        if (!reason.empty()) {
            throw py::value_error(std::string(name) + ": " + reason +
                                  (option == ReaderOption::Weld ? "; repair() joins nearby nodes and segments" : ""));
        }
    }
}

/// Returns the format of a file; null if it is unknown.
const FileFormat *formatOf(const PythonFile &file) {
    return !file.options.formatId.empty() ? allFormats().withId(file.options.formatId)
           : file.options.content         ? allFormats().detect(file.path, *file.options.content)
                                          : allFormats().detect(file.path);
}

Result<PythonDomain> readDomainFile(const PythonFile &file, ImportNotes &notes) {
    const FileFormat *const format = formatOf(file);
    if (format != nullptr && format->kind == FileKind::Project) {
        const Result<Document> document = readDocument(file.path, file.options, &notes);
        if (!document) {
            return document.faults();
        }
        MeshingJob job = forefront::jobOf(*document);
        PythonDomain domain{std::move(job.domain), std::move(job.spacing),  job.options,
                            std::move(job.cracks), std::move(job.periodic), std::move(job.mapped),
                            std::move(job.strips), std::move(job.layers),   std::move(job.regionElements)};
        domain.unit = document->unit;
        domain.limits = document->limits;
        return domain;
    }
    Result<DomainFile> read = allFormats().readDomain(file.path, file.options, &notes);
    if (!read) {
        return read.faults();
    }
    PythonDomain domain{std::move(read->domain), std::move(read->spacing),  {},
                        std::move(read->cracks), std::move(read->periodic), std::move(read->mapped)};
    domain.periodicOfMesh = domain.periodic;
    domain.unit = read->unit;
    return domain;
}

/// Returns true for maps, whose readers name the parts, since the places are in the coordinates of the file.
bool namesPartsItself(const PythonFile &file) {
    const FileFormat *const format = formatOf(file);
    return format != nullptr && format->kind == FileKind::Map;
}

PythonDomain readDomainOf(const py::object &source, const std::string &format, const py::dict &given) {
    PythonFile file = fileOf(source, format);
    setImportOptions(file.options, given);
    if (const FileFormat *const known = formatOf(file); known != nullptr) {
        refuseOptionsWithout(*known, given);
    }
    file.options.progress = progressOf(py::none());
    ImportNotes notes;
    PythonDomain domain = valueOrRaise(withoutGil([&] { return readDomainFile(file, notes); }));
    domain.notes = notes.diagnostics();
    if (!namesPartsItself(file)) {
        namePartsOf(file.options.partNames, domain);
    }
    domain.system = notes.contents().system;
    return domain;
}

py::dict fieldArrays(const NamedFields &fields) {
    py::dict arrays;
    for (const auto &[name, values] : fields) {
        arrays[name.c_str()] = copyOfValues<double>(values);
    }
    return arrays;
}

/// Returns the mesh, the values of its nodes and the values of its elements.
py::tuple readMeshOf(const py::object &source, const std::string &format) {
    PythonFile file = fileOf(source, format);
    file.options.progress = progressOf(py::none());
    ImportNotes notes;
    MeshFields read =
        valueOrRaise(withoutGil([&] { return allFormats().readFields(file.path, file.options, &notes); }));
    PythonMesh mesh = pythonMesh(std::move(read.mesh));
    mesh.notes = notes.diagnostics();
    return py::make_tuple(std::move(mesh), fieldArrays(read.fields), fieldArrays(read.elementFields));
}

SpacingSpec readSizes(const py::object &source, const std::string &format,
                      const std::optional<std::array<double, 6>> &picture) {
    PythonFile file = fileOf(source, format);
    if (const FileFormat *const known = formatOf(file);
        picture && known != nullptr && known->kind != FileKind::Picture) {
        throw py::value_error(std::string("black, white, box: only pictures have colours; the file is in the format ") +
                              known->name);
    }
    if (picture) {
        const auto &p = *picture;
        file.options.picture = PictureSizes{p[0], p[1], {{p[2], p[3]}, {p[4], p[5]}}, false};
    }
    return valueOrRaise(withoutGil([&] { return allFormats().readSpacing(file.path, file.options); }));
}

py::list formatList() {
    py::list list;
    for (const FileFormat &format : allFormats().list()) {
        py::dict row;
        row["id"] = format.id;
        row["name"] = format.name;
        row["extension"] = format.extension;
        row["reads_domain"] = format.readsDomain;
        row["reads_mesh"] = format.readsMesh;
        row["reads_sizes"] = format.readsSpacing;
        row["writes_mesh"] = format.writesMesh;
        row["elevation"] = format.writesMesh && format.holdsElevations;
        row["extrude"] = format.writesMesh && format.holdsSolids;
        row["open"] = format.writesMesh && format.hasOpenBoundaries;
        row["tags"] = format.writesMesh && format.tellsTagsApart;
        row["unit"] = format.writesMesh && format.namesUnit;
        list.append(row);
    }
    return list;
}

} // namespace

void bindReading(py::module_ &module) {
    module.def("read_domain", &readDomainOf);
    module.def("read_mesh", &readMeshOf);
    module.def("read_sizes", &readSizes);
    module.def("formats", &formatList);
}

} // namespace forefront::python
