#include "tpg_runtime.h"
