#include "core/files/files.hpp"
#include "core/files/format.hpp"

#include <memory>
#include <utility>

// Reading files in memory.

namespace forefront {
namespace {

/// Returns the options with the content of a file in memory, and with the format that its name is the id of.
ImportOptions memoryOptions(const FormatList &list, MemoryFile &file, const ImportOptions &options) {
    ImportOptions own = options;
    own.content = std::make_shared<const std::string>(std::move(file.bytes));
    if (own.formatId.empty() && list.ofId(file.name) != nullptr) {
        own.formatId = file.name;
    }
    if (file.name.empty()) {
        file.name = "memory";
    }
    return own;
}

} // namespace

Result<DomainFile> FormatList::readDomain(MemoryFile file, const ImportOptions &options, ImportNotes *notes) const {
    const ImportOptions own = memoryOptions(*this, file, options);
    return readDomain(std::filesystem::path(file.name), own, notes);
}

Result<Mesh> FormatList::readMesh(MemoryFile file, const ImportOptions &options, ImportNotes *notes) const {
    const ImportOptions own = memoryOptions(*this, file, options);
    return readMesh(std::filesystem::path(file.name), own, notes);
}

Result<MeshFields> FormatList::readFields(MemoryFile file, const ImportOptions &options, ImportNotes *notes) const {
    const ImportOptions own = memoryOptions(*this, file, options);
    return readFields(std::filesystem::path(file.name), own, notes);
}

Result<SpacingSpec> FormatList::readSpacing(MemoryFile file, const ImportOptions &options, ImportNotes *notes) const {
    const ImportOptions own = memoryOptions(*this, file, options);
    return readSpacing(std::filesystem::path(file.name), own, notes);
}

Result<DomainFile> readDomain(MemoryFile file, const ImportOptions &options, ImportNotes *notes) {
    return engineFormats().readDomain(std::move(file), options, notes);
}

Result<Mesh> readMesh(MemoryFile file, const ImportOptions &options, ImportNotes *notes) {
    return engineFormats().readMesh(std::move(file), options, notes);
}

Result<MeshFields> readFields(MemoryFile file, const ImportOptions &options, ImportNotes *notes) {
    return engineFormats().readFields(std::move(file), options, notes);
}

Result<SpacingSpec> readSpacing(MemoryFile file, const ImportOptions &options, ImportNotes *notes) {
    return engineFormats().readSpacing(std::move(file), options, notes);
}

} // namespace forefront
