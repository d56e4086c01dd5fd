#pragma once

#include "core/drawing/domain/shared_domain.hpp"
#include "core/engine/layers/layer_rows.hpp"
#include "core/engine/spacing/shared_spacing.hpp"
#include "ui/background/latest.hpp"

#include <cstdint>
#include <memory>

namespace forefront {

/// The rows of the boundary layers of a document, before it is meshed.
struct LayerPlan {
    std::uint64_t revision = 0; ///< of the document
    LayerRows rows;             ///< none: the document has no layers, or they cannot be found
};

/// Finds the rows of boundary layers on a separate thread, so that they follow each change of a drawing without a run.
/// Call all members from one thread; none of them waits, except the destructor.
class LayerPlanner {
  public:
    explicit LayerPlanner(BackgroundList &list);

    /// Sets the document whose layers are planned; cheap if the revision has not changed. Work on an earlier revision
    /// is cancelled; its plan stays until that of the new one is found. `spacing`: where others need the field of the
    /// document, too.
    void submit(std::shared_ptr<SharedDomain> drawn, std::uint64_t revision, std::shared_ptr<SharedSpacing> spacing);
    /// Cancels the work and drops its results, because another document has been opened, or its mesh has the layers.
    void abandon();
    /// Fetches the newest plan. Returns true if it is new.
    bool refresh() { return worker_.refresh(); }
    /// Returns the plan fetched last; never null.
    const std::shared_ptr<const LayerPlan> &plan() const { return worker_.now(); }

  private:
    struct Request {
        std::shared_ptr<SharedDomain> drawn;
        std::shared_ptr<SharedSpacing> spacing;
        std::uint64_t revision = 0;
    };
    using Answer = std::shared_ptr<const LayerPlan>;
    static Answer answer(const LatestTurn<Request, Answer> &turn);

    std::uint64_t wanted_ = 0; ///< revision
    Latest<Request, Answer> worker_;
};

} // namespace forefront
