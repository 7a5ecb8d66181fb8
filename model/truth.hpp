#pragma once

namespace steadyslide {

/// Three-valued: "not shown" is not "false". There is no conversion to bool.
enum class Truth { no, unknown, yes };

}  // namespace steadyslide
