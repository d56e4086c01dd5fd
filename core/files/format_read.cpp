#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/coordinate_range.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/files/common/dropped_fields.hpp"
#include "core/files/common/element_sizes.hpp"
#include "core/files/format.hpp"
#include "core/files/read_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <utility>

// Reading files through a list of formats.

namespace forefront {
Result<const Format *> chooseFormat(const FormatList &list, const std::filesystem::path &path, std::string_view bytes,
                                    const ImportOptions &options, bool (*accepts)(const Format &)) {
    if (!options.formatId.empty()) {
        const Format *const given = list.ofId(options.formatId);
        if (given == nullptr || !accepts(*given)) {
            return error("unknown-format",
                         given == nullptr ? "unknown format '" + options.formatId + "'"
                                          : "the format '" + options.formatId + "' cannot be read here",
                         "expected one of " + list.ids(accepts));
        }
        return given;
    }
    const Format *const found = list.ofContent(path, bytes);
    if (found == nullptr) {
        return error("unknown-format", "unknown file format", "formats that can be read: " + list.extensions(accepts));
    }
    if (!accepts(*found)) {
        return error("unknown-format", std::string(found->about.name) + " cannot be read here",
                     "formats that can be read: " + list.extensions(accepts));
    }
    return found;
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

bool withinRange(const Mesh &mesh) {
    return std::none_of(mesh.nodes.begin(), mesh.nodes.end(), tooLarge);
}
Diagnostics outOfRange(const Mesh &mesh) {
    const auto far = std::find_if(mesh.nodes.begin(), mesh.nodes.end(), tooLarge);
    return error("out-of-range",
                 "node " + std::to_string(far - mesh.nodes.begin() + 1) + " of the mesh, at " + placeText(*far) +
                     ", has a coordinate beyond 1e60 in magnitude",
                 "scale the mesh down");
}

bool readsDomain(const Format &format) {
    return format.canReadDomain();
}

/// Reads a mesh. Error: out-of-range, since areas of larger elements overflow.
Result<Mesh> meshWithin(const Format &format, const SourceText &source) {
    Result<Mesh> mesh = format.readMesh(source);
    if (mesh && !withinRange(*mesh)) {
        return outOfRange(*mesh);
    }
    return mesh;
}

/// Reads a mesh and its values. Error: out-of-range.
Result<MeshFields> fieldsWithin(const Format &format, const SourceText &source) {
    Result<MeshFields> file = format.readFields(source);
    if (file && !withinRange(file->mesh)) {
        return outOfRange(file->mesh);
    }
    return file;
}

/// Reads a mesh whose values are of no use, and notes which values there are.
Result<Mesh> meshAlone(const Format &format, const SourceText &source) {
    if (format.readFields == nullptr) {
        return meshWithin(format, source);
    }
    Result<MeshFields> file = fieldsWithin(format, source);
    if (!file) {
        return file.faults();
    }
    if (const std::string dropped = droppedFields(*file); !dropped.empty()) {
        source.note(kDroppedFields, dropped, 0);
    }
    return std::move(file->mesh);
}

/// Notes that open lines of a mesh are read as cracks, and what their faces lose.
void noteCracks(const Mesh &mesh, const MeshDomain &made, const SourceText &source) {
    const auto keeps = [&](std::int32_t tag) {
        return std::any_of(made.domain.segments.begin(), made.domain.segments.end(),
                           [tag](const DomainSegment &segment) { return segment.tag == tag; });
    };
    for (const OpenLine &line : made.lines) {
        const std::string name = boundaryName(made.domain.boundaryNames, line.tag),
                          other = line.other == 0 ? std::string() : boundaryName(mesh.boundaryNames, line.other);
        const bool lost = !other.empty() && other != crackFaceName(name) && !keeps(line.other);
        source.note("crack",
                    "the mesh is open along " + countText(line.edges, "edge") + ", first at " + placeText(line.at) +
                        ": read as the crack " + name + (lost ? "; its other face was " + other : std::string()),
                    0);
    }
}

} // namespace

Result<DomainFile> domainFrom(const Format &format, const SourceText &source) {
    if (format.readDomain != nullptr) {
        return format.readDomain(source);
    }
    const auto mesh = meshAlone(format, source);
    if (!mesh) {
        return mesh.faults();
    }
    const OpenLineRule rule = source.options.keepSharedLines ? OpenLineRule::OwnTags : OpenLineRule::All;
    Result<MeshDomain> outline = domainOfMesh(*mesh, source.options.progress, rule);
    if (!outline) {
        return outline.faults();
    }
    noteCracks(*mesh, *outline, source);
    if (const std::size_t left = mesh->periodic.size() - outline->periodic.size(); left > 0) {
        source.note("periodic",
                    "ignored " + countText(left, "pair") +
                        " of periodic parts that lie inside the domain or meet a crack; expected parts of its boundary",
                    0);
    }
    DomainFile file;
    file.domain = std::move(outline->domain);
    file.cracks = std::move(outline->cracks);
    file.periodic = std::move(outline->periodic);
    return file;
}

Result<DomainFile> FormatList::readDomain(const std::filesystem::path &path, const ImportOptions &options,
                                          ImportNotes *notes) const {
    return readFile<DomainFile>(*this, path, options, notes, readsDomain, domainFrom);
}

Diagnostics FormatList::locateFaults(const std::filesystem::path &path, Diagnostics faults,
                                     const ImportOptions &options) const {
    std::error_code none;
    const auto wanting = [](const Diagnostic &f) {
        return f.file.empty() && (!f.parts.empty() || f.code.starts_with("expression-"));
    };
    const bool readable = options.content != nullptr || std::filesystem::is_regular_file(path, none); // a pipe is empty
    if (readable && std::any_of(faults.begin(), faults.end(), wanting)) {
        const auto read = readFile<DomainFile>(*this, path, options, nullptr, readsDomain,
                                               [&](const Format &format, SourceText source) {
                                                   DomainOrigin origin;
                                                   source.origin = &origin;
                                                   Result<DomainFile> file = domainFrom(format, source);
                                                   if (file) {
                                                       addPlaces(faults, origin, source.text);
                                                   }
                                                   return file;
                                               });
        static_cast<void>(read); // it was readable before; if it no longer is, the faults are left without places
    }
    return named(std::move(faults), path);
}

Result<Mesh> FormatList::readMesh(const std::filesystem::path &path, const ImportOptions &options,
                                  ImportNotes *notes) const {
    return readFile<Mesh>(
        *this, path, options, notes, [](const Format &format) { return format.readMesh != nullptr; },
        [](const Format &format, const SourceText &source) { return meshWithin(format, source); });
}

Result<MeshFields> FormatList::readFields(const std::filesystem::path &path, const ImportOptions &options,
                                          ImportNotes *notes) const {
    return readFile<MeshFields>(
        *this, path, options, notes, [](const Format &format) { return format.readMesh != nullptr; },
        [](const Format &format, const SourceText &source) -> Result<MeshFields> {
            if (format.readFields != nullptr) {
                Result<MeshFields> fields = fieldsWithin(format, source);
                if (fields) {
                    dropInfinite(fields->fields);
                    dropInfinite(fields->elementFields);
                }
                return fields;
            }
            Result<Mesh> mesh = meshWithin(format, source);
            return mesh ? Result<MeshFields>(MeshFields{std::move(*mesh), {}, {}}) : mesh.faults();
        });
}

Result<MeshField> FormatList::readField(const std::filesystem::path &path, std::string_view name,
                                        const ImportOptions &options, ImportNotes *notes) const {
    return readFile<MeshField>(
        *this, path, options, notes, [](const Format &format) { return format.readFields != nullptr; },
        [name](const Format &format, const SourceText &source) -> Result<MeshField> {
            Result<MeshFields> fields = fieldsWithin(format, source);
            return fields ? meshWithField(std::move(*fields), name, source) : fields.faults();
        });
}

Result<SpacingSpec> FormatList::readSpacing(const std::filesystem::path &path, const ImportOptions &options,
                                            ImportNotes *notes) const {
    return readFile<SpacingSpec>(
        *this, path, options, notes,
        [](const Format &format) { return format.readSpacing != nullptr || format.readMesh != nullptr; },
        [](const Format &format, const SourceText &source) -> Result<SpacingSpec> {
            if (format.readSpacing != nullptr) {
                return format.readSpacing(source);
            }
            Result<Mesh> mesh = meshWithin(format, source);
            return mesh ? elementSizes(*mesh, source) : mesh.faults();
        });
}

} // namespace forefront
