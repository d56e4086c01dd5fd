#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/source/domain_origin.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/source/import_options.hpp"
#include "core/files/source/text_place.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace FOREFRONT_API forefront {

/// The bytes of an input file and where they come from. Readers work on this alone, so that tests and fuzzers feed them
/// from memory; `path` is empty there, and companion files (.node beside .poly) are then out of reach.
struct SourceText {
    std::string_view text;
    std::string name;           ///< as shown in messages
    std::filesystem::path path; ///< of the file itself, for finding its companions; may be empty
    ImportOptions options;
    DomainOrigin *origin = nullptr; ///< where a reader of domains records the places of the parts; null: nowhere
    LengthUnit *unit = nullptr;     ///< where a reader of drawings records the unit of the coordinates; null: nowhere
    ImportNotes *notes = nullptr;   ///< receives notes on unused content; null: no notes

    /// Reports the unit of the coordinates.
    void measured(LengthUnit in) const {
        if (unit != nullptr) {
            *unit = in;
        }
    }
    /// Reports unused content at byte `offset`.
    void note(std::string_view code, const std::string &message, std::size_t offset, std::size_t count = 1) const {
        if (notes != nullptr) {
            notes->add(code, message, name, text, offset, count);
        }
    }
    /// Warns that the content at byte `offset` may lead to an unexpected result.
    void warn(std::string_view code, const std::string &message, std::size_t offset) const {
        if (notes != nullptr) {
            notes->add(code, message, name, text, offset, 1, Severity::Warning);
        }
    }
    /// Reports the numbers of the nodes and elements of a mesh.
    void numbered(const PartNumbers &nodes, const PartNumbers &elements) const {
        if (notes != nullptr) {
            notes->setNumbers({nodes, elements});
        }
    }
    /// Reports the contents of a drawing or map.
    void reportContents(const DrawingContents &contents) const {
        if (notes != nullptr) {
            notes->setContents(contents);
        }
    }
};

/// Returns one error that carries file, line and column of `offset`.
Diagnostic faultAt(const SourceText &source, std::size_t offset, std::string code, std::string message,
                   std::string advice = {});

/// Returns a token as quoted in a message: printable, shortened.
std::string inQuotes(std::string_view token);

/// Returns the whole content of a file without the byte order mark that some editors put before UTF-8. Faults:
/// cannot-read with the text of errno, too-large, cancelled.
Result<std::string> readFileBytes(const std::filesystem::path &path, std::size_t maxBytes,
                                  const Progress &progress = {});
/// Does the same for a regular file, and refuses anything else, such as a pipe, on which reading could wait for ever.
Result<std::string> readRegularFile(const std::filesystem::path &path, std::size_t maxBytes,
                                    const Progress &progress = {});
/// Returns why a path that must be a regular file is something else that can be read, such as a pipe or a device; empty
/// for files, and also for folders and missing files, which reading refuses. Fault: cannot-read.
Status notRegular(const std::filesystem::path &path);
/// Returns everything on standard input up to its end, without a byte order mark. Faults as for readFileBytes().
Result<std::string> readStandardInput(std::size_t maxBytes);

} // namespace forefront
