#pragma once

#include <gtest/gtest.h>

#include <umbral/gl/context.hpp>

namespace umbral::gl {

/// A context for one test, drawn without threads as the runs are, by the back end that UMBRAL_GL names.
class GlTest : public testing::Test {
protected:
    GlTest() : context_(without_threads()) {}

    OffscreenContext& context() { return context_; }

private:
    static BackendKind without_threads()
    {
        forbid_driver_threads();
        return default_backend();
    }

    OffscreenContext context_;
};

}
