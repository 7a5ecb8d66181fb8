#include "numeric/coarse_contact.hpp"
