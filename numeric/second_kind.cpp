#include "numeric/second_kind.hpp"
