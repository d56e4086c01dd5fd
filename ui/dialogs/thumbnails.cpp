#include "ui/dialogs/thumbnails.hpp"

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/improve/improve.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace forefront {
namespace {

/// Approximate number of elements of a thumbnail; more would blur into grey at this size.
constexpr double kElements = 700.0;

void addEdges(const TriMesh &mesh, Thumbnail &thumbnail) {
    const auto number = [](NodeId id) { return static_cast<std::uint32_t>(index(id)); };
    for (const Element &e : mesh.elements) {
        thumbnail.elements.push_back({number(e[0]), number(e[1]), number(e[2])});
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = number(e[k]), b = number(e[(k + 1) % 3]);
            thumbnail.edges.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::sort(thumbnail.edges.begin(), thumbnail.edges.end());
    thumbnail.edges.erase(std::unique(thumbnail.edges.begin(), thumbnail.edges.end()), thumbnail.edges.end());
    for (const TaggedEdge &edge : mesh.edges) {
        thumbnail.boundary.push_back({number(edge.a), number(edge.b)});
    }
}

void addFineness(const TriMesh &mesh, const SpacingField &spacing, Thumbnail &thumbnail) {
    const double lowest = std::log(spacing.minimum()), span = std::log(spacing.maximum()) - lowest;
    for (const Element &e : mesh.elements) {
        const Vec2 middle = (1.0 / 3.0) * (mesh.nodes[index(e[0])] + mesh.nodes[index(e[1])] + mesh.nodes[index(e[2])]);
        const double t = span > 0.02 ? (std::log(spacing.at(middle)) - lowest) / span : 0.5;
        thumbnail.fineness.push_back(static_cast<float>(std::clamp(t, 0.0, 1.0)));
    }
}

std::shared_ptr<const Thumbnail> thumbnailOf(const Result<Document> &document, const std::stop_token &stop) {
    auto thumbnail = std::make_shared<Thumbnail>();
    if (!document) {
        return thumbnail;
    }
    const MeshingJob job = jobOf(*document);
    Progress progress;
    progress.stop = stop;
    const Result<PreparedJob> prepared = planMesh(job, progress, kElements);
    if (!prepared) {
        return thumbnail;
    }
    const std::unique_ptr<Mesher> mesher = Mesher::create(prepared->frontBoundary(), prepared->spacing, job.options);
    if (hasErrors(advanceToEnd(*mesher, *prepared, job.options, "", progress))) {
        return thumbnail;
    }
    TriMesh mesh = std::move(*mesher).takeMesh();
    improve(mesh, {job.options.improve, 1, prepared->spacing.get()}, progress);
    thumbnail->box = mesh.bounds();
    addEdges(mesh, *thumbnail);
    addFineness(mesh, *prepared->spacing, *thumbnail);
    thumbnail->nodes = std::move(mesh.nodes);
    return thumbnail;
}

using ThumbnailTurn = LatestTurn<std::vector<std::filesystem::path>, std::vector<std::shared_ptr<const Thumbnail>>>;

std::vector<std::shared_ptr<const Thumbnail>> makeAll(const ThumbnailTurn &turn, const Thumbnails::Make &make) {
    std::vector<std::shared_ptr<const Thumbnail>> made(turn.request.size());
    for (std::size_t i = 0; i < made.size() && !turn.stop.stop_requested(); ++i) {
        try {
            made[i] = make(turn.request[i], turn.stop);
        } catch (const std::bad_alloc &) {
            made[i] = std::make_shared<const Thumbnail>(); // no picture, as for a project with faults
        }
        turn.publish(made);
    }
    return made;
}

} // namespace

std::shared_ptr<const Thumbnail> makeThumbnail(const std::filesystem::path &project, const std::stop_token &stop) {
    ImportOptions options;
    options.regularFile = true;
    return thumbnailOf(readDocument(project, options), stop);
}

std::shared_ptr<const Thumbnail> makeThumbnail(const std::string &projectText, const std::stop_token &stop) {
    return thumbnailOf(parseProject(projectText, {}), stop);
}

Thumbnails::Thumbnails(BackgroundList &list, std::vector<std::filesystem::path> projects)
    : Thumbnails(list, std::move(projects), [](const std::filesystem::path &project, const std::stop_token &stop) {
          return makeThumbnail(project, stop);
      }) {}

Thumbnails::Thumbnails(BackgroundList &list, std::vector<std::filesystem::path> projects, Make make)
    : worker_(
          list, [make = std::move(make)](const ThumbnailTurn &turn) { return makeAll(turn, make); },
          Made(projects.size()), LeavableThread::kPatience) {
    if (!projects.empty()) {
        worker_.submit(std::move(projects));
    }
}

bool Thumbnails::done() const {
    const Made &made = worker_.now();
    return std::all_of(made.begin(), made.end(), [](const auto &thumbnail) { return thumbnail != nullptr; });
}

} // namespace forefront
