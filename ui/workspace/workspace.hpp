#pragma once

#include "core/edit/references.hpp"
#include "ui/widgets/widget_context.hpp"
#include "ui/workspace/document_examiner.hpp"
#include "ui/workspace/document_store.hpp"
#include "ui/workspace/mesh_judge.hpp"
#include "ui/workspace/message_log.hpp"
#include "ui/workspace/probe.hpp"
#include "ui/workspace/run_control.hpp"
#include "ui/workspace/snapping.hpp"
#include "ui/workspace/view.hpp"

#include <memory>

namespace forefront {

/// The open document with its view and selection, and everything computed from it.
struct Workspace : WidgetContext {
    DocumentStore document;
    MessageLog log{document};
    RunControl run;
    DocumentExaminer examiner;
    std::shared_ptr<const DocumentPreview> preview; ///< of this frame, never null
    MeshJudge judge;
    std::shared_ptr<const Judgement> judgement; ///< of this frame, never null
    Probe probe;
    View view;
    Selection selection;
    Snapping snapping;

    explicit Workspace(Platform &owner)
        : WidgetContext(owner), run(document, log, [&owner] { owner.wake(); }), examiner([&owner] { owner.wake(); }),
          preview(examiner.latest()), judge([&owner] { owner.wake(); }), judgement(judge.latest()) {}
};

} // namespace forefront
