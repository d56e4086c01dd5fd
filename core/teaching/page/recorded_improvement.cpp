#include "core/teaching/page/recorded_improvement.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/teaching/page/recorded_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>

namespace forefront {

namespace {

/// A place in units of length.
struct UnitPlace {
    std::int64_t x = 0, y = 0;
};

/// The corners of an element; the last one of a triangle is kNoIndex.
using Corners = std::array<std::uint32_t, 4>;

/// Returns the corners of an element with the smallest number first, which tells it from all others. `numberOf`: gives
/// the number of a node.
template <class NumberOf>
Corners cornersFrom(std::span<const NodeId> nodes, const NumberOf &numberOf) {
    Corners corners{kNoIndex, kNoIndex, kNoIndex, kNoIndex};
    const auto end = std::ranges::transform(nodes, corners.begin(), numberOf).out;
    std::rotate(corners.begin(), std::min_element(corners.begin(), end), end);
    return corners;
}

/// Returns the figures of a step as the player shows them.
std::string figuresText(const ImproveStep &step) {
    if (!step.quads) {
        return numberText(step.after.alphaMean, 4) + ',' + numberText(step.after.alphaMin, 4);
    }
    return step.measured
               ? numberText(step.quadsAfter.jacobianMean, 4) + ',' + numberText(step.quadsAfter.jacobianMin, 4) + ',' +
                     std::to_string(step.quadsAfter.irregular)
               : std::string();
}

/// A list of numbers as JSON, with its name; nothing if it is empty.
class NamedList {
  public:
    explicit NamedList(const char *name) : text_(std::string(",\"") + name + "\":[") {}

    template <class... Numbers>
    void add(Numbers... numbers) {
        ((text_ += (std::exchange(empty_, false) ? "" : ",") + std::to_string(numbers)), ...);
    }
    std::string text() const { return empty_ ? std::string() : text_ + ']'; }

  private:
    std::string text_;
    bool empty_ = true;
};

/// Follows the nodes and elements of a mesh through the steps of its improvement.
class ImprovementTracker {
  public:
    /// `width`: corners written for each element, 3 or 4.
    ImprovementTracker(const Mesh &front, unsigned width) : width_(width) {
        const Vec2 size = front.bounds().size();
        constexpr double kUnits = 1e5; // in the size of the mesh; a tenth of a pixel of a wide screen
        unit_ = std::max({size.x, size.y, 1e-300}) / kUnits;
        for (const Vec2 node : front.nodes) {
            places_.push_back(inUnits(node));
        }
        keepNodes(front.nodes, [](std::size_t n) { return static_cast<std::uint32_t>(n); });
        const MeshView view(front);
        for (std::size_t e = 0; e < view.elementCount(); ++e) {
            slots_.push_back(
                cornersFrom(view.cornersOf(e), [](NodeId node) { return static_cast<std::uint32_t>(node); }));
            slotOf_[slots_.back()] = e;
        }
    }

    double unit() const { return unit_; }

    /// Returns a step, which leads to this mesh, as JSON.
    std::string take(const ImproveStep &step, std::size_t steps, const MeshView &mesh) {
        const std::string text = caption(step, steps);
        std::string json =
            "{\"w\":" + scriptString(text.substr(text.find(": ") + 2)) + ",\"f\":[" + figuresText(step) + ']';
        const std::vector<std::uint32_t> numbers = takeNodes(step, mesh.nodes, json);
        takeElements(mesh, numbers, json);
        return json + '}';
    }

  private:
    UnitPlace inUnits(Vec2 p) const { return {std::llround(p.x / unit_), std::llround(p.y / unit_)}; }

    template <class NumberOf>
    void keepNodes(std::span<const Vec2> nodes, NumberOf numberOf) {
        known_.clear();
        for (std::size_t n = nodes.size();
             n-- > 0;) { // of nodes in one place, such as those of a crack, the first is last
            known_[{nodes[n].x, nodes[n].y}].push_back(numberOf(n));
        }
    }

    /// Returns the lasting number of each node, and appends what became of the nodes.
    std::vector<std::uint32_t> takeNodes(const ImproveStep &step, std::span<const Vec2> nodes, std::string &json) {
        std::vector<Vec2> before(nodes.begin(), nodes.end());
        for (const ImproveStep::Move &move : step.moves) {
            before[index(move.node)] = move.from;
        }
        NamedList moved("m"), added("n"), removed("r");
        std::vector<std::uint32_t> numbers;
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const auto found = known_.find({before[n].x, before[n].y});
            const UnitPlace place = inUnits(nodes[n]);
            if (found == known_.end() || found->second.empty()) {
                numbers.push_back(static_cast<std::uint32_t>(places_.size()));
                places_.push_back(place);
                added.add(place.x, place.y);
                continue;
            }
            const std::uint32_t number = found->second.back();
            found->second.pop_back();
            numbers.push_back(number);
            UnitPlace &shown = places_[number];
            if (shown.x != place.x || shown.y != place.y) {
                moved.add(number, place.x - shown.x, place.y - shown.y);
                shown = place;
            }
        }
        for (const auto &[place, left] : known_) {
            for (const std::uint32_t number : left) {
                removed.add(number);
            }
        }
        keepNodes(nodes, [&numbers](std::size_t n) { return numbers[n]; });
        json += moved.text() + added.text() + removed.text();
        return numbers;
    }

    /// Appends which places of the list of elements have changed.
    void takeElements(const MeshView &mesh, const std::vector<std::uint32_t> &numbers, std::string &json) {
        std::vector<Corners> made;
        std::vector<bool> stays(slots_.size(), false);
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            const Corners corners =
                cornersFrom(mesh.cornersOf(e), [&numbers](NodeId node) { return numbers[index(node)]; });
            if (const auto slot = slotOf_.find(corners); slot != slotOf_.end()) {
                stays[slot->second] = true;
            } else {
                made.push_back(corners);
            }
        }
        NamedList changed("c");
        std::size_t next = 0;
        for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
            const bool vacant = slots_[slot] == kVacant;
            if (stays[slot] || (vacant && next == made.size())) {
                continue;
            }
            slotOf_.erase(slots_[slot]);
            slots_[slot] = next < made.size() ? made[next++] : kVacant;
            addSlot(slot, changed);
        }
        for (; next < made.size(); ++next) {
            slots_.push_back(made[next]);
            addSlot(slots_.size() - 1, changed);
        }
        json += changed.text();
    }
    void addSlot(std::size_t slot, NamedList &changed) {
        const Corners &corners = slots_[slot];
        changed.add(slot);
        for (unsigned k = 0; k < width_; ++k) {
            changed.add(corners[k] == kNoIndex ? std::int64_t{-1} : std::int64_t{corners[k]});
        }
        if (corners != kVacant) {
            slotOf_[corners] = slot;
        }
    }

    static constexpr Corners kVacant{kNoIndex, kNoIndex, kNoIndex, kNoIndex};

    unsigned width_;
    double unit_ = 0.0;
    std::vector<UnitPlace> places_;                                         ///< by lasting number, as shown
    std::map<std::pair<double, double>, std::vector<std::uint32_t>> known_; ///< numbers of the nodes at a place
    std::vector<Corners> slots_;
    std::map<Corners, std::size_t> slotOf_;
};

} // namespace

void RecordedImprovement::limit(std::size_t maxBytes) {
    std::size_t bytes = 0, kept = 0;
    while (kept < steps.size() && bytes + steps[kept].size() <= maxBytes) {
        bytes += steps[kept++].size();
    }
    steps.resize(kept);
}

RecordedImprovement recordImprovement(MeshStepper &stepper, const Mesh &front, unsigned width, std::size_t maxBytes,
                                      const Progress &progress) {
    ImprovementTracker tracker(front, width);
    RecordedImprovement record;
    record.width = width;
    record.unit = tracker.unit();
    std::size_t bytes = 0;
    constexpr SnapshotLayers kMesh{.mesh = true, .front = false, .cells = false, .explanation = false};
    constexpr SnapshotLayers kFiguresAlone{.mesh = false, .front = false, .cells = false, .explanation = false};
    record.total = stepper.snapshot(kFiguresAlone)->improveSteps;
    while (record.steps.size() < record.total && !progress.cancelled()) {
        stepper.step(Granularity::Event, 1);
        const std::shared_ptr<const SessionSnapshot> now = stepper.snapshot(kMesh);
        if (!now->improvement || now->improveStep != record.steps.size() + 1) {
            break;
        }
        if (record.steps.empty()) {
            record.before = now->improvement->quadsBefore;
        }
        std::string step = tracker.take(*now->improvement, record.total, now->mesh->view());
        bytes += step.size();
        if (bytes > maxBytes) {
            break;
        }
        record.steps.push_back(std::move(step));
    }
    // A step forward shows the figures of the last step, which may be one that is not recorded.
    const std::size_t done = stepper.snapshot(kFiguresAlone)->improveStep;
    stepper.step(Granularity::Event, static_cast<std::int64_t>(record.total - std::min(done, record.total)));
    if (const auto last = stepper.snapshot(kFiguresAlone)->improvement) {
        record.after = last->quadsAfter;
    }
    return record;
}

} // namespace forefront
