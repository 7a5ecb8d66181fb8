#include "numeric/jacobi_rule.hpp"
