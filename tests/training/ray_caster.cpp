// The ray caster as C++, as it is built where there is no GPU.
#include "raycast.cu"
