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

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>
#include <vector>

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

void setOverlap(ImportOptions &options, const std::string &word) {
    const std::optional<OverlapRule> rule = fromWord<OverlapRule>(word);
    if (!rule) {
        throw py::value_error("overlap: expected " + wordList<OverlapRule>() + ", got '" + word + "'");
    }
    options.overlap = *rule;
}

void setDegrees(ImportOptions &options, const std::string &word) {
    if (word != "warn" && word != "keep" && word != "local") {
        throw py::value_error("degrees: expected warn, keep or local, got '" + word + "'");
    }
    options.degrees = word == "warn" ? DegreeRule::Warn : word == "keep" ? DegreeRule::Keep : DegreeRule::Local;
}

/// Takes a name, or a list of names.
void setLayer(ImportOptions &options, const py::handle &value) {
    if (py::isinstance<py::str>(value)) {
        options.layer = value.cast<std::string>();
        return;
    }
    options.layer.emplace();
    for (const std::string &name : value.cast<std::vector<std::string>>()) {
        *options.layer += (options.layer->empty() ? "" : ",") + name;
    }
}

void setParts(ImportOptions &options, const py::handle &value) {
    for (const auto &[part, places] : value.cast<std::map<std::string, std::array<std::array<double, 2>, 2>>>()) {
        const auto &[from, to] = places;
        options.partNames.push_back({part, {from[0], from[1]}, {to[0], to[1]}});
    }
}

/// An option of Domain.read(): its keyword, what it takes, and how it is set.
struct ReadingOption {
    const char *name;
    const char *expected;
    void (*set)(ImportOptions &, const py::handle &);
};

/// Sets a member of the options from a Python value.
template <auto Member, class Value>
void setMember(ImportOptions &options, const py::handle &value) {
    options.*Member = value.cast<Value>();
}

constexpr ReadingOption kReadingOptions[] = {
    {"curve_tolerance", "a length", &setMember<&ImportOptions::curveTolerance, double>},
    {"weld", "a length", &setMember<&ImportOptions::weldTolerance, double>},
    {"layer", "a name, or a list of names", &setLayer},
    {"names", "the name of a property", &setMember<&ImportOptions::nameProperty, std::string>},
    {"sizes", "the name of a property", &setMember<&ImportOptions::sizeProperty, std::string>},
    {"projection", "a text such as 'EPSG:3067'", &setMember<&ImportOptions::projection, std::string>},
    {"overlap", "'later' or 'smaller'",
     [](ImportOptions &options, const py::handle &value) { setOverlap(options, value.cast<std::string>()); }},
    {"strict", "True or False", &setMember<&ImportOptions::strict, bool>},
    {"beyond_page", "True or False", &setMember<&ImportOptions::beyondPage, bool>},
    {"drop_lines", "True or False", &setMember<&ImportOptions::dropLines, bool>},
    {"stroke_areas", "True or False", &setMember<&ImportOptions::strokeAreas, bool>},
    {"shape_regions", "True or False", &setMember<&ImportOptions::shapeRegions, bool>},
    {"white_holes", "True or False", &setMember<&ImportOptions::whiteHoles, bool>},
    {"degrees", "'warn', 'keep' or 'local'",
     [](ImportOptions &options, const py::handle &value) { setDegrees(options, value.cast<std::string>()); }},
    {"parts", "a dict such as {'inlet': ((0, 0), (0, 1))}", &setParts},
    {"parameters", "a dict of expressions such as {'r': '2*t'}",
     &setMember<&ImportOptions::parameters, std::map<std::string, std::string>>},
};

std::vector<std::string> readingOptionNames() {
    std::vector<std::string> names;
    for (const ReadingOption &option : kReadingOptions) {
        names.emplace_back(option.name);
    }
    return names;
}

/// Takes options of readers from keyword arguments.
void setImportOptions(ImportOptions &options, const py::dict &given) {
    for (const auto &[key, value] : given) {
        const auto name = key.cast<std::string>();
        const auto *const option = std::find_if(std::begin(kReadingOptions), std::end(kReadingOptions),
                                                [&](const ReadingOption &each) { return each.name == name; });
        if (option == std::end(kReadingOptions)) {
            throw py::type_error("unknown option '" + name + "' of a reader");
        }
        try {
            option->set(options, value);
        } catch (const py::cast_error &) {
            throw py::type_error(name + ": expected " + option->expected + ", got " +
                                 py::repr(value).cast<std::string>());
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
        Result<MeshingJob> job = readJobOf(*document, file.path.string(), &notes);
        if (!job) {
            return job.faults();
        }
        PythonDomain domain{std::move(job->domain), std::move(job->spacing),  job->options,
                            std::move(job->cracks), std::move(job->periodic), std::move(job->mapped),
                            std::move(job->strips), std::move(job->layers),   std::move(job->regionElements)};
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
    module.def("reading_options", &readingOptionNames, "Returns the keywords of Domain.read()");
    module.def("read_mesh", &readMeshOf);
    module.def("read_sizes", &readSizes);
    module.def("formats", &formatList);
}

} // namespace forefront::python
