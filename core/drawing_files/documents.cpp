#include "core/drawing_files/documents.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/hole_markers.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/format.hpp"
#include "core/files/read_file.hpp"

#include <string>
#include <utility>

namespace forefront {
namespace {

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

Result<Document> documentFrom(const Format &format, const SourceText &source) {
    if (format.about.kind == FileKind::Project) {
        return readProjectText(source);
    }
    const Result<DomainFile> file = domainFrom(format, source);
    if (!file) {
        return file.faults();
    }
    noteHoleMarkers(file->domain, source);
    return fromDomain(*file);
}

} // namespace

Result<Document> readDocument(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return readFile<Document>(
        allFormats(), path, options, notes, [](const Format &format) { return format.canReadDomain(); }, documentFrom);
}

Result<MeshingJob> readJobOf(const Document &document, const std::string &file, ImportNotes *notes) {
    MeshingJob job = jobOf(document);
    if (hasErrors(job.findings)) {
        for (Diagnostic &fault : job.findings) {
            fault.file = file;
        }
        return std::move(job.findings);
    }
    for (const Diagnostic &finding : std::exchange(job.findings, {})) {
        if (notes != nullptr) {
            notes->add(finding.code, finding.message, file, {}, 0, 1, finding.severity);
        }
    }
    return job;
}

} // namespace forefront
