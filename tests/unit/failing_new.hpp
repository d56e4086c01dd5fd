#pragma once

namespace forefront::testing {

/// Makes one allocation of this thread fail while it exists: the one after the first `allowed`. Without effect in
/// builds with a sanitizer.
class FailingNew {
  public:
    explicit FailingNew(long allowed);
    ~FailingNew();
    FailingNew(const FailingNew &) = delete;
    FailingNew &operator=(const FailingNew &) = delete;
};

} // namespace forefront::testing
