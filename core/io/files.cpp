#include "core/io/files.hpp"

#include "core/base/number_text.hpp"
#include "core/edit/document.hpp"
#include "core/edit/hole_markers.hpp"
#include "core/io/foreign_files.hpp"
#include "core/io/format.hpp"
#include "core/io/json/json_outline.hpp"
#include "core/io/source/reorder_origin.hpp"
#include "core/io/text/atomic_file.hpp"
#include "core/io/triangle/triangle.hpp"
#include "core/mesh/mesh_domain.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <new>
#include <utility>

namespace forefront {

namespace {

/// Sets the file of faults that do not name one.
Diagnostics named(Diagnostics faults, const std::filesystem::path &path) {
    for (Diagnostic &fault : faults) {
        if (fault.file.empty()) {
            fault.file = path.string();
        }
    }
    return faults;
}

bool canReadDomain(const Format &format) {
    return format.readDocument != nullptr || format.readDomain != nullptr || format.readMesh != nullptr;
}

bool canWriteMesh(const Format &format) {
    return format.writeMesh != nullptr || format.writeFiles != nullptr;
}

/// Returns the format for writing a mesh; null if there is none.
const Format *meshFormat(const std::filesystem::path &path, std::string_view id) {
    const Format *format = id.empty() ? formatOfExtension(path, canWriteMesh) : formatOfId(id);
    return format != nullptr && canWriteMesh(*format) ? format : nullptr;
}

/// Returns the extensions of the accepted formats, for messages.
std::string extensions(bool (*accepts)(const Format &)) {
    std::string list;
    for (const Format &format : formats()) {
        if (accepts(format) && list.find(format.about.extension) == std::string::npos) {
            list += (list.empty() ? "" : " ") + std::string(format.about.extension);
        }
    }
    return list;
}

/// Returns the ids of the accepted formats, for messages.
std::string formatIds(bool (*accepts)(const Format &)) {
    std::string list;
    for (const Format &format : formats()) {
        if (accepts(format)) {
            list += (list.empty() ? "" : ", ") + std::string(format.about.id);
        }
    }
    return list;
}

Result<const Format *> chooseFormat(const std::filesystem::path &path, std::string_view bytes,
                                    const ImportOptions &options, bool (*accepts)(const Format &)) {
    if (!options.formatId.empty()) {
        const Format *const given = formatOfId(options.formatId);
        if (given == nullptr || !accepts(*given)) {
            return error("unknown-format",
                         given == nullptr ? "unknown format '" + options.formatId + "'"
                                          : "the format '" + options.formatId + "' cannot be read here",
                         "expected one of " + formatIds(accepts));
        }
        return given;
    }
    const Format *const found = formatOf(path, bytes);
    if (found == nullptr) {
        return error("unknown-format", "unknown file format", "formats that can be read: " + extensions(accepts));
    }
    if (!accepts(*found)) {
        return error("unknown-format", std::string(found->about.name) + " cannot be read here",
                     "formats that can be read: " + extensions(accepts));
    }
    return found;
}

/// Loads a file, finds its format and passes both to `read`. Running out of memory is a fault like any other.
template <class T, class Read>
Result<T> readFile(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes,
                   bool (*accepts)(const Format &), Read read) {
    try {
        std::string loaded;
        if (options.content == nullptr) {
            Result<std::string> bytes = readFileBytes(path, options.maxBytes, options.progress);
            if (!bytes) {
                return bytes.faults();
            }
            loaded = std::move(*bytes);
        }
        const std::string &bytes = options.content != nullptr ? *options.content : loaded;
        if (bytes.empty()) {
            return named(error("empty-file", "the file is empty"), path);
        }
        if (bytes.starts_with("\x1f\x8b")) {
            return named(
                error("compressed", "the file is compressed", "unpack it first, for example with gunzip -c FILE >NEW"),
                path);
        }
        if (options.formatId.empty()) {
            if (Diagnostics foreign = foreignFile(bytes); !foreign.empty()) {
                return named(std::move(foreign), path);
            }
        }
        const Result<const Format *> format = chooseFormat(path, bytes, options, accepts);
        if (!format) {
            return named(format.faults(), path);
        }
        SourceText source{bytes, path.string(), options.content != nullptr ? std::filesystem::path() : path, options};
        source.notes = notes;
        Result<T> result = read(**format, source);
        if (!result) {
            Diagnostics faults = named(result.faults(), path);
            if (!faults.empty() && faults.front().advice.empty() && faults.front().code != "cancelled") {
                faults.front().advice = std::string("the file was read as ") + (*format)->about.name;
            }
            if (notes != nullptr) { // what was left out may be why nothing remains
                const Diagnostics remarks = notes->diagnostics();
                faults.insert(faults.end(), remarks.begin(), remarks.end());
            }
            return faults;
        }
        return result;
    } catch (const std::bad_alloc &) {
        return named(error("out-of-memory", "not enough memory to read the file"), path);
    }
}

/// Converts a domain to a document and back, which orders its segments by chains, so that it meshes the same in the
/// editor and in batch; reorders `origin`, if not null, accordingly.
Domain asDrawn(const Domain &domain, DomainOrigin *origin) {
    Domain drawn = toDomain(fromDomain(domain));
    if (origin != nullptr) {
        reorderOrigin(domain, drawn, *origin);
    }
    return drawn;
}

Result<Domain> domainFrom(const Format &format, const SourceText &source) {
    if (format.readDocument != nullptr) {
        const auto document = format.readDocument(source);
        if (!document) {
            return document.faults();
        }
        return toDomain(*document);
    }
    if (format.readDomain != nullptr) {
        Result<Domain> domain = format.readDomain(source);
        if (domain && (format.about.arranges || !domain->curves.empty())) {
            return asDrawn(*domain, source.origin);
        }
        return domain;
    }
    const auto mesh = format.readMesh(source);
    if (!mesh) {
        return mesh.faults();
    }
    return domainOfMesh(*mesh, source.options.progress);
}

/// Reports hole markers that a drawing cannot keep: holes in it are loops inside others.
void noteHoleMarkers(const Domain &domain, const SourceText &source) {
    const std::vector<Vec2> idle = idleHoleMarkers(domain);
    if (!idle.empty()) {
        source.note("hole-outside",
                    (idle.size() == 1
                         ? "left out 1 hole marker that lies in no hole, at "
                         : "left out " + std::to_string(idle.size()) + " hole markers that lie in no hole, first at ") +
                        placeText(idle.front()) + "; a loop inside another is a hole",
                    0);
    }
}

} // namespace

const FileFormat *fileFormatOf(const std::filesystem::path &path) {
    std::string head(kHeadBytes, '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
    if (stream.good() && beginsAsObject(head) && recognisedFormat(path, head) == nullptr) {
        if (const Result<std::string> all = readFileBytes(path, ImportOptions().maxBytes)) {
            return fileFormatOf(path, *all);
        }
    }
    return fileFormatOf(path, head);
}

const FileFormat *fileFormatOf(const std::filesystem::path &path, std::string_view content) {
    const Format *const format = formatOf(path, content);
    return format == nullptr ? nullptr : &format->about;
}

Result<Document> readDocument(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return readFile<Document>(path, options, notes, canReadDomain,
                              [](const Format &format, const SourceText &source) -> Result<Document> {
                                  if (format.readDocument != nullptr) {
                                      return format.readDocument(source);
                                  }
                                  const auto domain = domainFrom(format, source);
                                  if (!domain) {
                                      return domain.faults();
                                  }
                                  noteHoleMarkers(*domain, source);
                                  return fromDomain(*domain);
                              });
}

Result<Domain> readDomain(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return readFile<Domain>(path, options, notes, canReadDomain, domainFrom);
}

Diagnostics locateFaults(const std::filesystem::path &path, Diagnostics faults, const ImportOptions &options) {
    std::error_code none;
    const auto wanting = [](const Diagnostic &f) { return f.file.empty() && !f.parts.empty(); };
    const bool readable = options.content != nullptr || std::filesystem::is_regular_file(path, none); // a pipe is empty
    if (readable && std::any_of(faults.begin(), faults.end(), wanting)) {
        const auto read =
            readFile<Domain>(path, options, nullptr, canReadDomain, [&](const Format &format, SourceText source) {
                DomainOrigin origin;
                source.origin = &origin;
                Result<Domain> domain = domainFrom(format, source);
                if (domain) {
                    addPlaces(faults, origin, source.text);
                }
                return domain;
            });
        static_cast<void>(read); // it was readable before; if it no longer is, the faults are left without places
    }
    return named(std::move(faults), path);
}

Result<Mesh> readMesh(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return readFile<Mesh>(
        path, options, notes, [](const Format &format) { return format.readMesh != nullptr; },
        [](const Format &format, const SourceText &source) { return format.readMesh(source); });
}

namespace {

/// Marks infinite values as absent: ranges, colours and contours cannot show them.
void dropInfinite(NamedFields &fields) {
    for (auto &[name, values] : fields) {
        std::replace_if(
            values.begin(), values.end(), [](double value) { return std::isinf(value); },
            std::numeric_limits<double>::quiet_NaN());
    }
}

} // namespace

Result<MeshFields> readFields(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return readFile<MeshFields>(
        path, options, notes, [](const Format &format) { return format.readMesh != nullptr; },
        [](const Format &format, const SourceText &source) -> Result<MeshFields> {
            if (format.readFields != nullptr) {
                Result<MeshFields> fields = format.readFields(source);
                if (fields) {
                    dropInfinite(fields->fields);
                    dropInfinite(fields->elementFields);
                }
                return fields;
            }
            Result<Mesh> mesh = format.readMesh(source);
            return mesh ? Result<MeshFields>(MeshFields{std::move(*mesh), {}, {}}) : mesh.faults();
        });
}

Result<MeshField> readField(const std::filesystem::path &path, std::string_view name, const ImportOptions &options,
                            ImportNotes *notes) {
    return readFile<MeshField>(
        path, options, notes, [](const Format &format) { return format.readFields != nullptr; },
        [name](const Format &format, const SourceText &source) -> Result<MeshField> {
            Result<MeshFields> fields = format.readFields(source);
            return fields ? meshWithField(std::move(*fields), name, source) : fields.faults();
        });
}

Result<SpacingSpec> readSpacing(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return readFile<SpacingSpec>(
        path, options, notes, [](const Format &format) { return format.readSpacing != nullptr; },
        [](const Format &format, const SourceText &source) { return format.readSpacing(source); });
}

Status writeMesh(const std::filesystem::path &path, const Mesh &mesh, std::string_view formatId,
                 const Progress &progress) {
    const Format *format = meshFormat(path, formatId);
    if (format == nullptr) {
        return named(
            error("unknown-format",
                  formatId.empty() ? "unknown extension '" + path.extension().string() + "' of a mesh file"
                                   : "unknown mesh format '" + std::string(formatId) + "'",
                  "expected one of " + (formatId.empty() ? extensions(canWriteMesh) : formatIds(canWriteMesh))),
            path);
    }
    try {
        if (format->writeFiles != nullptr) {
            return named(format->writeFiles(path, mesh, progress), path);
        }
        constexpr std::size_t kBytesPerNode = 45, kBytesPerElement = 32;
        return writeTextFile(
            path, [&](TextWriter &out) { format->writeMesh(mesh, out); }, progress,
            1 + mesh.nodes.size() * kBytesPerNode + mesh.elements.size() * kBytesPerElement);
    } catch (const std::bad_alloc &) {
        return named(error("out-of-memory", "not enough memory to write the file"), path);
    }
}

Status writeMesh(ByteSink &sink, const Mesh &mesh, std::string_view formatId) {
    const Format *const format = formatOfId(formatId);
    if (format == nullptr || format->writeMesh == nullptr) {
        return error("unknown-format",
                     format == nullptr ? "unknown mesh format '" + std::string(formatId) + "'"
                                       : std::string(format->about.name) + " cannot be written to a stream",
                     "expected one of " + formatIds([](const Format &f) { return f.writeMesh != nullptr; }));
    }
    TextWriter out(sink);
    format->writeMesh(mesh, out);
    return out.flush() ? Status{} : error("cannot-write", "cannot write to the stream");
}

Diagnostics exportNotes(const std::filesystem::path &path, const Mesh &mesh, std::string_view formatId) {
    const Format *const format = meshFormat(path, formatId);
    return format != nullptr && format->noteChanges != nullptr ? named(format->noteChanges(mesh), path) : Diagnostics{};
}

bool acceptsInnerEdges(const std::filesystem::path &path, std::string_view formatId) {
    const Format *const format = meshFormat(path, formatId);
    return format == nullptr || format->about.acceptsInnerEdges;
}

std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path &path, std::string_view formatId) {
    const Format *format = meshFormat(path, formatId);
    if (format == nullptr || format->writeFiles == nullptr) {
        return {path};
    }
    std::vector<std::filesystem::path> files;
    for (const char *extension : kTriangleExtensions) {
        files.push_back(path);
        files.back().replace_extension(extension);
    }
    return files;
}

std::vector<std::filesystem::path> filesRead(const std::filesystem::path &path) {
    std::vector<std::filesystem::path> files = filesOfMesh(path);
    std::filesystem::path nodes = path;
    nodes.replace_extension(".node");
    std::error_code none;
    const bool poly = formatOfExtension(path, [](const Format &format) { return format.readDomain == readPoly; });
    if (poly && std::filesystem::is_regular_file(path, none) && std::filesystem::is_regular_file(nodes, none)) {
        const auto bytes = readFileBytes(path, ImportOptions().maxBytes);
        if (bytes && hasNodesInNodeFile({*bytes, path.string(), path, {}})) {
            files.push_back(nodes);
        }
    }
    return files;
}

Status checkPlace(const std::filesystem::path &path) {
    std::error_code none;
    const std::filesystem::path folder = path.parent_path();
    if (path.empty()) {
        return error("cannot-write", "the path has no file name", "add one");
    }
    if (std::filesystem::is_directory(path, none)) {
        return error("cannot-write", "cannot write the file: it is a folder", "name a file in it");
    }
    if (!folder.empty() && !std::filesystem::is_directory(folder, none)) {
        return error("cannot-write", "cannot write the file: folder " + folder.string() + " not found",
                     "create it, or choose another");
    }
    return {};
}

} // namespace forefront
