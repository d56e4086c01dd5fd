#pragma once

#include "core/base/progress.hpp"
#include "core/io/files.hpp"
#include "core/io/source/source.hpp"
#include "core/io/text/text_writer.hpp"

#include <filesystem>
#include <span>
#include <string_view>

namespace forefront {

/// The functions of a file format. A new format is a folder with these functions and one line in formats.cpp. Readers
/// work from memory and never throw; a null function means that the format does not support it.
struct Format {
    FileFormat about;
    /// Further extensions, separated by blanks, such as ".node .ele".
    const char *otherExtensions = "";
    /// Returns true if the first bytes of a file (at most kHeadBytes) show that it is of this format.
    bool (*recognise)(std::string_view head) = nullptr;
    bool mayShowLate = false; ///< recognise() takes all of a JSON text where its first bytes show no format
    Result<Document> (*readDocument)(const SourceText &) = nullptr; ///< where a format holds more than a domain
    Result<Domain> (*readDomain)(const SourceText &) = nullptr;     ///< null: the domain of its mesh, if it has one
    Result<Mesh> (*readMesh)(const SourceText &) = nullptr;
    Result<SpacingSpec> (*readSpacing)(const SourceText &) = nullptr;
    Result<MeshFields> (*readFields)(const SourceText &) = nullptr; ///< null: holds no values
    void (*writeMesh)(const Mesh &, TextWriter &) = nullptr;
    /// Returns notes on what the format changes in the mesh, such as names; null: it changes nothing.
    Diagnostics (*noteChanges)(const Mesh &) = nullptr;
    /// Writes a mesh for formats of several files; else null.
    Status (*writeFiles)(const std::filesystem::path &, const Mesh &, const Progress &) = nullptr;
};

inline constexpr std::size_t kHeadBytes = 4096;

/// Returns all formats, in the order of menus and, among those of one extension, of preference.
std::span<const Format> formats();

/// Returns the format that the first bytes of a file show, preferably one with the extension of the path; null if they
/// show none.
const Format *recognisedFormat(const std::filesystem::path &path, std::string_view head);
/// Returns the format of a file by its content, else by its extension; null if neither identifies it.
const Format *formatOf(const std::filesystem::path &path, std::string_view content);
/// Returns the first format with the extension of a path for which `accepts` returns true; null if there is none.
const Format *formatOfExtension(const std::filesystem::path &path, bool (*accepts)(const Format &));
/// Returns the format of that id; null if there is none.
const Format *formatOfId(std::string_view id);

} // namespace forefront
