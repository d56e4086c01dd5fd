#pragma once

#include "core/files/foreign_files.hpp"
#include "core/files/format.hpp"
#include "core/files/named_faults.hpp"

#include <new>
#include <string_view>
#include <utility>

namespace forefront {

/// Returns the format to read a file with: the one that the options name, else by content, then by extension. Fault:
/// unknown-format.
Result<const Format *> chooseFormat(const FormatList &list, const std::filesystem::path &path, std::string_view bytes,
                                    const ImportOptions &options, bool (*accepts)(const Format &));

/// Loads a file, finds its format and passes both to `read`. Running out of memory is a fault like any other.
template <class T, class Read>
Result<T> readFile(const FormatList &list, const std::filesystem::path &path, const ImportOptions &options,
                   ImportNotes *notes, bool (*accepts)(const Format &), Read read) {
    try {
        std::string loaded;
        if (options.content == nullptr) {
            Result<std::string> bytes = options.regularFile ? readRegularFile(path, options.maxBytes, options.progress)
                                                            : readFileBytes(path, options.maxBytes, options.progress);
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
        // What a component reads is told from other files by its content alone.
        const Format *const shown = list.recognised(path, std::string_view(bytes).substr(0, kHeadBytes));
        if (options.formatId.empty() && (shown == nullptr || *shown->about.component == '\0')) {
            if (Diagnostics foreign = foreignFile(bytes); !foreign.empty()) {
                return named(std::move(foreign), path);
            }
        }
        const Result<const Format *> format = chooseFormat(list, path, bytes, options, accepts);
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

} // namespace forefront
