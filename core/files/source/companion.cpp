#include "core/files/source/companion.hpp"

#include <filesystem>
#include <utility>

namespace forefront {

Result<std::unique_ptr<Companion>> readCompanion(const SourceText &source, const char *extension) {
    std::filesystem::path path = source.path;
    if (path.empty()) {
        return Diagnostics{
            faultAt(source, 0, "cannot-read", std::string("a ") + extension + " file beside this one is missing")};
    }
    path.replace_extension(extension);
    auto bytes = readRegularFile(path, source.options.maxBytes);
    if (!bytes) {
        return bytes.faults();
    }
    auto companion = std::make_unique<Companion>();
    companion->bytes = std::move(*bytes);
    companion->source = {companion->bytes, path.string(), path, source.options};
    companion->source.notes = source.notes;
    return companion;
}

} // namespace forefront
