#pragma once

namespace forefront {

struct Shell;

/// Logs what the page refers to and the run or the window does not have, once they show the page. Called once per frame
/// while a lesson is open.
void checkPage(Shell &context);

} // namespace forefront
