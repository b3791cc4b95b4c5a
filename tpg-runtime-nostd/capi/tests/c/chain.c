/* Prints a chain at each pose, a line each: tip, points, axes, Jacobian and what a ball is near to, as bits. */
#include "tpg_runtime.h"

#include "chain.h"

#include <stdio.h>
#include <string.h>

static void print(const float *values, size_t count)
{
    for (size_t at = 0; at < count; at++) {
        uint32_t bits = 0;
        (void)memcpy(&bits, &values[at], sizeof bits);
        (void)printf("%08lx ", (unsigned long)bits);
    }
}

int main(void)
{
    static const size_t joints = sizeof links / sizeof links[0];
    tpg_placed_t placed;
    tpg_near_t near;
    tpg_link_t wrong = links[0];

    wrong.axis = 3U;
    if (tpg_chain_place(&wrong, 1U, tip, poses[0], &placed) != TPG_ARGUMENT
        || tpg_chain_place(links, 0U, tip, poses[0], &placed) != TPG_LENGTH
        || tpg_chain_place(links, TPG_CHAIN_JOINTS + 1U, tip, poses[0], &placed) != TPG_LENGTH
        || tpg_chain_place(links, joints, NULL, poses[0], &placed) != TPG_NULL) {
        return 1;
    }
    for (size_t at = 0; at < sizeof poses / sizeof poses[0]; at++) {
        float jacobian[3U * TPG_CHAIN_JOINTS];
        if (tpg_chain_place(links, joints, tip, poses[at], &placed) != TPG_OK || placed.joints != joints
            || tpg_chain_jacobian(&placed, jacobian, 3U * joints - 1U) != TPG_LENGTH
            || tpg_chain_jacobian(&placed, jacobian, 3U * joints) != TPG_OK
            || tpg_chain_near(&placed, radii, balls[at], &near) != TPG_OK) {
            return 2;
        }
        print(placed.tip, 3U);
        for (size_t joint = 0; joint < joints; joint++) {
            print(placed.points[joint], 3U);
            print(placed.axes[joint], 3U);
            print(&jacobian[3U * joint], 3U);
        }
        print(&near.clearance, 1U);
        print(near.point, 3U);
        print(near.gradient, joints);
        (void)printf("%lu\n", (unsigned long)near.link);
    }
    placed.joints = TPG_CHAIN_JOINTS + 1U;
    return (tpg_chain_near(&placed, radii, balls[0], &near) == TPG_LENGTH) ? 0 : 3;
}
