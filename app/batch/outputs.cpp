#include "app/batch/outputs.hpp"

#include "app/batch/inputs.hpp"
#include "app/batch/open_boundaries.hpp"
#include "app/batch/standard_output.hpp"
#include "app/batch/suggestion.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/elevations.hpp"
#include "core/files/files.hpp"
#include "core/files/open_boundaries.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

/// Returns a suggestion for a mistyped id or extension of a format that can be written.
std::string formatSuggestion(const std::string &word, const char *FileFormat::*kind) {
    std::vector<std::string_view> words;
    for (const FileFormat &format : allFormats().list()) {
        if (format.writesMesh) {
            words.emplace_back(format.*kind);
        }
    }
    return suggestion(word, words);
}

/// Returns one word per format that can be written, without repetition.
std::string listOf(const char *FileFormat::*word) {
    std::string list;
    for (const FileFormat &format : allFormats().list()) {
        if (format.writesMesh && (", " + list + ',').find(std::string(" ") + format.*word + ',') == std::string::npos) {
            list += (list.empty() ? "" : ", ") + std::string(format.*word);
        }
    }
    return list;
}

/// Returns true if a word is a proper name within the name of a format, such as "abaqus" in "Abaqus and CalculiX".
bool namesProgram(const std::string &word, const std::string &name) {
    constexpr std::size_t kShortest = 3; // letters
    const std::size_t at = lowerCase(name).find(lowerCase(word));
    return word.size() >= kShortest && at != std::string::npos && (at == 0 || name[at - 1] == ' ') && name[at] >= 'A' &&
           name[at] <= 'Z';
}

/// Returns a suggestion for an unknown id: a similar id, or the id of the format of a program such as Abaqus.
std::string idSuggestion(const std::string &id) {
    const std::string similar = formatSuggestion(id, &FileFormat::id);
    const std::vector<FileFormat> formats = allFormats().list();
    const auto known = std::find_if(formats.begin(), formats.end(), [&](const FileFormat &format) {
        return format.writesMesh && namesProgram(id, format.name);
    });
    return !similar.empty() || known == formats.end() ? similar : std::string("; did you mean ") + known->id + '?';
}

std::filesystem::path resolved(const std::filesystem::path &file) {
    std::error_code none;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file, none), none);
}

} // namespace

std::string formatIds() {
    return listOf(&FileFormat::id);
}

std::string checkFormat(const std::filesystem::path &output, const std::string &id) {
    const std::vector<const FileFormat *> named = allFormats().withExtensionOf(output);
    if (id.empty()) {
        if (isStandardStream(output)) {
            return "-o -: standard output needs a format; add --format with one of " + formatIds();
        }
        const bool known = std::any_of(named.begin(), named.end(), [](const FileFormat *f) { return f->writesMesh; });
        return known ? ""
                     : "-o " + output.string() + ": unknown extension '" + output.extension().string() +
                           "'; expected one of " + listOf(&FileFormat::extension) +
                           formatSuggestion(output.extension().string(), &FileFormat::extension);
    }
    const FileFormat *const chosen = allFormats().withId(id);
    if (chosen == nullptr || !chosen->writesMesh) {
        return "--format: unknown format '" + id + "'; expected one of " + formatIds() + idSuggestion(id);
    }
    if (isStandardStream(output) && filesOfMesh("x", id).size() > 1) {
        return "-o -: format " + id + " needs several files; name a file, or choose another format";
    }
    if (!named.empty() && std::find(named.begin(), named.end(), chosen) == named.end()) {
        return "-o " + output.string() + ": the extension belongs to " + named.front()->name + ", but --format " + id +
               " is " + chosen->name + " (" + chosen->extension + "); formats apply to outputs in order";
    }
    return {};
}

std::vector<Output> pairFormats(const std::vector<std::filesystem::path> &outputs,
                                const std::vector<std::string> &formats) {
    std::vector<Output> pairs;
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        pairs.push_back({outputs[k], k < formats.size() ? formats[k] : std::string()});
    }
    return pairs;
}

std::string checkFormats(const std::vector<std::filesystem::path> &outputs, const std::vector<std::string> &formats) {
    if (formats.size() > outputs.size()) {
        return "more --format options than outputs; formats apply to outputs in order";
    }
    if (std::count_if(outputs.begin(), outputs.end(), isStandardStream) > 1) {
        return "-o -: standard output is given twice";
    }
    for (const Output &output : pairFormats(outputs, formats)) {
        std::string wrong = checkFormat(output.path, output.format);
        if (!wrong.empty()) {
            return wrong;
        }
    }
    return {};
}

bool usesStandardOutput(const std::vector<std::filesystem::path> &outputs) {
    return std::any_of(outputs.begin(), outputs.end(), isStandardStream);
}

namespace {

Diagnostics writeOutput(FileSet &files, const Output &output, const MeshView &mesh, const ExportOptions &options,
                        const Progress &progress) {
    if (!isStandardStream(output.path)) {
        Status written = writeMesh(files, output.path, mesh, output.format, progress, options);
        return hasErrors(written) ? written : exportNotes(output.path, mesh, output.format, options);
    }
    StandardOutput sink;
    const Status status = writeMesh(sink, mesh, output.format, options);
    return sink.failure() != 0 ? sink.status() : status;
}

/// Returns a note on the file of an output.
Diagnostic noteOn(const Output &output, std::string code, std::string message) {
    Diagnostic note = noteOf(std::move(code), std::move(message));
    note.file = isStandardStream(output.path) ? "" : output.path.string();
    return note;
}

/// Reports that inner edges were left out because of the format.
Diagnostic innerEdgesNote(const Output &output, std::size_t count) {
    return noteOn(
        output, "inner-edges",
        "left out " + countText(count, "tagged edge") +
            " inside the domain: in this format, every tagged edge is a boundary; --inner-edges keep writes " +
            (count == 1 ? "it" : "them"));
}

/// Reports how thick a plane mesh becomes.
Diagnostic thicknessNote(const Output &output, const MeshView &mesh) {
    return noteOn(output, "thickness",
                  "the mesh is one cell thick, " + numberText(usualExtrusion(mesh).height, 4) +
                      " as the elements are wide; --extrude H sets the thickness");
}

/// The forms of a mesh that outputs need, each made once.
class FormedMeshes {
  public:
    explicit FormedMeshes(const MeshView &mesh) : mesh_(mesh) {}
    /// Returns the mesh in a form, valid as long as this object.
    MeshView get(bool withoutInner, Numbering numbering) {
        if (!withoutInner && numbering == Numbering::Creation) {
            return mesh_;
        }
        MeshView view = make(withoutInner, numbering);
        view.elevations = elevations(numbering);
        return view;
    }

  private:
    MeshView make(bool withoutInner, Numbering numbering) {
        std::optional<Mesh> &made = made_[withoutInner ? 1 : 0][numbering == Numbering::Creation ? 0 : 1];
        if (!made && numbering == Numbering::Creation) {
            made = withoutInnerEdges(mesh_);
        } else if (!made) {
            made = renumbered(get(withoutInner, Numbering::Creation), numbers());
        }
        return *made;
    }

    /// Returns the elevations of the nodes with their new numbers.
    std::span<const double> elevations(Numbering numbering) {
        if (numbering == Numbering::Creation || mesh_.elevations.empty()) {
            return mesh_.elevations;
        }
        if (renumbered_.empty()) {
            renumbered_ = renumberedElevations(mesh_.elevations, numbers());
        }
        return renumbered_;
    }

    std::span<const NodeId> numbers() {
        if (numbers_.empty()) {
            numbers_ = reverseCuthillMcKee(mesh_);
        }
        return numbers_;
    }

    const MeshView &mesh_;
    std::array<std::array<std::optional<Mesh>, 2>, 2> made_;
    std::vector<NodeId> numbers_;
    std::vector<double> renumbered_; ///< elevations
};

} // namespace

Diagnostics writeOutputs(FileSet &files, const std::vector<Output> &outputs, const MeshView &mesh, const MeshForm &form,
                         const Progress &progress) {
    FormedMeshes formed(mesh);
    Diagnostics notes;
    for (const Output &output : outputs) {
        const bool drops =
            form.innerEdges ? *form.innerEdges == InnerEdges::Drop : !acceptsInnerEdges(output.path, output.format);
        const MeshView written = formed.get(drops, form.numbering.value_or(usualNumbering(output.path, output.format)));
        const ExportOptions options = exportOptionsOf(form, written);
        Diagnostics faults = writeOutput(files, output, written, options, progress);
        if (hasErrors(faults)) {
            return faults;
        }
        notes.insert(notes.end(), faults.begin(), faults.end());
        const std::filesystem::path named = isStandardStream(output.path) ? std::filesystem::path() : output.path;
        for (Diagnostic &note : noteAllLand(output.path, output.format, options, "--open NAME opens a part")) {
            note.file = named.string();
            notes.push_back(std::move(note));
        }
        if (!form.extrusion && solidsOnly(output.path, output.format)) {
            notes.push_back(thicknessNote(output, written));
        }
        if (!form.innerEdges && written.edges.size() < mesh.edges.size()) {
            notes.push_back(innerEdgesNote(output, mesh.edges.size() - written.edges.size()));
        }
    }
    return notes;
}

Diagnostics writeAndCommit(const std::vector<Output> &outputs, const MeshView &mesh, const MeshForm &form,
                           const Progress &progress) {
    FileSet files;
    Diagnostics notes = writeOutputs(files, outputs, mesh, form, progress);
    if (hasErrors(notes)) {
        return notes;
    }
    const Status committed = files.commit();
    return committed.empty() ? notes : committed;
}

void printWritten(const std::vector<std::filesystem::path> &outputs, std::FILE *stream) {
    for (const std::filesystem::path &path : outputs) {
        if (!isStandardStream(path)) {
            std::fprintf(stream, "wrote %s\n", path.string().c_str());
        }
    }
}

Status printText(std::string_view text) {
    StandardOutput sink;
    sink.write(text);
    return sink.status();
}

Diagnostics checkOutputs(const std::vector<Output> &outputs, const std::vector<std::filesystem::path> &inputs) {
    Diagnostics faults;
    std::set<std::filesystem::path> read, written;
    const auto addTo = [](std::set<std::filesystem::path> &files, const std::vector<std::filesystem::path> &more) {
        bool added = true;
        for (const std::filesystem::path &file : more) {
            std::error_code none;
            const std::filesystem::file_status kind = std::filesystem::status(file, none);
            if (!std::filesystem::exists(kind) || std::filesystem::is_regular_file(kind)) { // a device accepts anything
                added = files.insert(resolved(file)).second && added;
            }
        }
        return added;
    };
    for (const std::filesystem::path &path : inputs) {
        if (!isStandardStream(path)) {
            addTo(read, filesRead(path));
        }
    }
    for (const Output &output : outputs) {
        if (isStandardStream(output.path)) {
            continue;
        }
        const std::vector<std::filesystem::path> files = filesOfMesh(output.path, output.format);
        Diagnostics wrong = checkPlace(output.path, output.format);
        if (wrong.empty() && std::any_of(files.begin(), files.end(), [&](const std::filesystem::path &file) {
                return read.count(resolved(file)) > 0;
            })) {
            wrong = error("cannot-write", "cannot write the file: it is an input", "choose another name");
        } else if (wrong.empty() && !addTo(written, files)) {
            wrong = error("cannot-write", "cannot write two outputs to one file", "give each its own name");
        }
        for (Diagnostic &fault : wrong) {
            fault.file = output.path.string();
            faults.push_back(std::move(fault));
        }
    }
    return faults;
}

} // namespace forefront
