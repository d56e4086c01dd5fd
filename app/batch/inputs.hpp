#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/files.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/source/import_options.hpp"

#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>

namespace forefront {

/// The name that stands for standard input and output on the command line.
inline constexpr const char *kStandardStream = "-";

/// Returns true if a path on the command line names standard input or output.
inline bool isStandardStream(const std::filesystem::path &path) {
    return path == kStandardStream;
}

/// An input of a command, ready for the functions of core/files/files.hpp.
struct Input {
    std::filesystem::path path; ///< as shown in messages
    ImportOptions options;      ///< with the content of standard input

    /// Returns the format by option, content or extension; null if unknown. Reads the beginning of the file once.
    const FileFormat *format() const;
    bool isProject() const;

    mutable std::optional<const FileFormat *> detected = {}; ///< by format()
};

/// Reads standard input if `path` is "-"; other files are left to their readers. `formatId` is the value of
/// --input-format, absent for inputs to which the option does not apply. Faults: cannot-read, too-large,
/// unknown-format.
Result<Input> openInput(const std::filesystem::path &path, const std::optional<std::string> &formatId = {});

/// Returns the error in --input-format or in the inputs of a command, at most one of which can be standard input; empty
/// if all are valid.
std::string checkInputs(std::initializer_list<std::optional<std::filesystem::path>> inputs,
                        const std::string &formatId = {});

/// Sets the values of --set. Returns an error if the input has no parameters; empty if it is a project.
std::string setParameters(Input &input, const std::map<std::string, std::string> &parameters);

/// Returns the error for options that have no effect on the format of an input, such as a weld tolerance where parts
/// are not joined; empty if they are valid. `repairs` is true if --repair is given.
std::string checkDrawingOptions(const DrawingArguments &drawing, const Input &input, bool repairs);

/// Names the parts of --name in the domain of an input, unless its reader did, as those of maps do. Returns the errors
/// of nameParts() or, if there are none and not `quiet`, its note.
Diagnostics namePartsOf(const DrawingArguments &drawing, const Input &input, bool quiet, Domain &domain);

/// Returns the ids of the formats that can be read, as --input-format accepts them, separated by commas.
std::string inputFormatIds();

/// Returns the extensions of the accepted formats, separated by commas, for help texts.
std::string extensionList(bool (*accepts)(const FileFormat &));
/// Returns the help text of an option or argument that names a mesh file.
std::string meshFileHelp();

/// Prints the notes of a reader to stderr, one per line; only the warnings if `quiet`.
void printNotes(const ImportNotes &notes, bool quiet);

} // namespace forefront
