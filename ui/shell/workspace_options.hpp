#pragma once

namespace forefront {

struct Shell;

namespace ui {
class Flow;
}

namespace shell {

/// Returns true if the workspace that is shown has options of its own in the options bar.
bool hasWorkspaceOptions(const Shell &context);
/// Draws those options: how to mesh in Mesh, how to step in Step, what to judge by in Judge. Each is an item of `flow`.
void drawWorkspaceOptions(Shell &context, ui::Flow &flow);

} // namespace shell
} // namespace forefront
