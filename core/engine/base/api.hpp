#pragma once

/// Marks a namespace whose declarations the shared library exports: `namespace FOREFRONT_API forefront {`. Every header
/// that core/forefront.hpp includes uses it; everything else stays hidden.
#if defined(__GNUC__)
#define FOREFRONT_API [[gnu::visibility("default")]]
#else
#define FOREFRONT_API
#endif
