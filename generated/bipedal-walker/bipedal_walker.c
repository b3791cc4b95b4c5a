/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix bipedal_walker --profile fast
 * Graph SHA-256: 073ef0a378cc8a602612e78e03be167dbc630525ff9afcc4c26a06f839168795
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 192 distinct operations.
 * Computes in f32 with own maths.
 */
#include "bipedal_walker.h"

#include <float.h>
#include <math.h>

#ifdef __FAST_MATH__
#error "fast-math reorders operations and drops NaN: the policy would act differently"
#endif
/* 16 widens what is narrower than float, and no float. */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16)
#error "float expressions must be computed in float: the policy would act differently"
#endif
/* A product and a sum are rounded each: nothing may fuse them. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off") /* GCC ignores the standard's pragma, and fuses in GNU modes and in C++. */
#elif defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)
#else
#pragma STDC FP_CONTRACT OFF
#endif

/* An output in its range. What is neither in it nor below is NaN. */
static float bipedal_walker_clamp(float value, float low, float high, float nan)
{
    return (value >= low) ? ((value > high) ? high : value) : ((value < low) ? low : nan);
}

void bipedal_walker_infer(const bipedal_walker_state_t *state, bipedal_walker_action_t *action)
{
    const float v2 = state->obs[0] * 0.43313652F;
    const float v5 = state->obs[1] * 0.006045125F;
    const float v6 = v2 + v5;
    const float v9 = state->obs[2] * (-0.9406402F);
    const float v10 = v6 + v9;
    const float v13 = state->obs[3] * 1.1379249F;
    const float v14 = v10 + v13;
    const float v17 = state->obs[4] * (-0.27293232F);
    const float v18 = v14 + v17;
    const float v21 = state->obs[5] * (-1.2722539F);
    const float v22 = v18 + v21;
    const float v25 = state->obs[6] * 0.99190795F;
    const float v26 = v22 + v25;
    const float v29 = state->obs[7] * (-0.46254736F);
    const float v30 = v26 + v29;
    const float v33 = state->obs[8] * (-0.36908358F);
    const float v34 = v30 + v33;
    const float v37 = state->obs[9] * 0.42084303F;
    const float v38 = v34 + v37;
    const float v41 = state->obs[10] * 0.23321724F;
    const float v42 = v38 + v41;
    const float v45 = state->obs[11] * (-0.11389011F);
    const float v46 = v42 + v45;
    const float v49 = state->obs[12] * 0.43208057F;
    const float v50 = v46 + v49;
    const float v53 = state->obs[13] * (-0.010095447F);
    const float v54 = v50 + v53;
    const float v57 = state->obs[14] * 4.4875813F;
    const float v58 = v54 + v57;
    const float v61 = state->obs[15] * (-9.051807F);
    const float v62 = v58 + v61;
    const float v65 = state->obs[16] * (-1.3506355F);
    const float v66 = v62 + v65;
    const float v69 = state->obs[17] * 8.500628F;
    const float v70 = v66 + v69;
    const float v73 = state->obs[18] * (-6.9748583F);
    const float v74 = v70 + v73;
    const float v77 = state->obs[19] * (-0.7869225F);
    const float v78 = v74 + v77;
    const float v81 = state->obs[20] * 7.8863435F;
    const float v82 = v78 + v81;
    const float v85 = state->obs[21] * (-3.1613417F);
    const float v86 = v82 + v85;
    const float v89 = state->obs[22] * 0.09573793F;
    const float v90 = v86 + v89;
    const float v93 = state->obs[23] * (-6.447783F);
    const float v94 = v90 + v93;
    const float v96 = v94 + 5.9709144F;
    const float v98 = state->obs[0] * (-0.6784458F);
    const float v100 = state->obs[1] * 2.167693F;
    const float v101 = v98 + v100;
    const float v103 = state->obs[2] * 3.1354392F;
    const float v104 = v101 + v103;
    const float v106 = state->obs[3] * (-5.378494F);
    const float v107 = v104 + v106;
    const float v109 = state->obs[4] * (-0.7907029F);
    const float v110 = v107 + v109;
    const float v112 = state->obs[5] * 0.15056907F;
    const float v113 = v110 + v112;
    const float v115 = state->obs[6] * (-2.3365674F);
    const float v116 = v113 + v115;
    const float v118 = state->obs[7] * (-0.04153449F);
    const float v119 = v116 + v118;
    const float v121 = state->obs[8] * 0.29449865F;
    const float v122 = v119 + v121;
    const float v124 = state->obs[9] * 0.37659582F;
    const float v125 = v122 + v124;
    const float v127 = state->obs[10] * 0.058632873F;
    const float v128 = v125 + v127;
    const float v130 = state->obs[11] * 2.3247058F;
    const float v131 = v128 + v130;
    const float v133 = state->obs[12] * 0.3777262F;
    const float v134 = v131 + v133;
    const float v136 = state->obs[13] * (-0.011592703F);
    const float v137 = v134 + v136;
    const float v139 = state->obs[14] * 10.344545F;
    const float v140 = v137 + v139;
    const float v142 = state->obs[15] * (-7.4077225F);
    const float v143 = v140 + v142;
    const float v145 = state->obs[16] * 2.2106109F;
    const float v146 = v143 + v145;
    const float v148 = state->obs[17] * (-9.954698F);
    const float v149 = v146 + v148;
    const float v151 = state->obs[18] * (-1.1742669F);
    const float v152 = v149 + v151;
    const float v154 = state->obs[19] * (-8.619116F);
    const float v155 = v152 + v154;
    const float v157 = state->obs[20] * 1.6254114F;
    const float v158 = v155 + v157;
    const float v160 = state->obs[21] * 1.084647F;
    const float v161 = v158 + v160;
    const float v163 = state->obs[22] * (-0.3101107F);
    const float v164 = v161 + v163;
    const float v166 = state->obs[23] * 18.147518F;
    const float v167 = v164 + v166;
    const float v169 = v167 + (-13.862106F);
    const float v171 = state->obs[0] * 2.1542137F;
    const float v173 = state->obs[1] * (-2.1436977F);
    const float v174 = v171 + v173;
    const float v176 = state->obs[2] * 1.353505F;
    const float v177 = v174 + v176;
    const float v179 = state->obs[3] * (-1.4395895F);
    const float v180 = v177 + v179;
    const float v182 = state->obs[4] * 1.4794261F;
    const float v183 = v180 + v182;
    const float v185 = state->obs[5] * 0.19376321F;
    const float v186 = v183 + v185;
    const float v188 = state->obs[6] * 0.22323757F;
    const float v189 = v186 + v188;
    const float v191 = state->obs[7] * 0.19982354F;
    const float v192 = v189 + v191;
    const float v194 = state->obs[8] * 0.14311513F;
    const float v195 = v192 + v194;
    const float v197 = state->obs[9] * (-0.81286705F);
    const float v198 = v195 + v197;
    const float v200 = state->obs[10] * (-0.44202605F);
    const float v201 = v198 + v200;
    const float v203 = state->obs[11] * 0.28939056F;
    const float v204 = v201 + v203;
    const float v206 = state->obs[12] * 0.08988224F;
    const float v207 = v204 + v206;
    const float v209 = state->obs[13] * (-0.035194054F);
    const float v210 = v207 + v209;
    const float v212 = state->obs[14] * (-1.4962751F);
    const float v213 = v210 + v212;
    const float v215 = state->obs[15] * (-2.571821F);
    const float v216 = v213 + v215;
    const float v218 = state->obs[16] * 7.4698043F;
    const float v219 = v216 + v218;
    const float v221 = state->obs[17] * (-4.813802F);
    const float v222 = v219 + v221;
    const float v224 = state->obs[18] * 0.45718148F;
    const float v225 = v222 + v224;
    const float v227 = state->obs[19] * 8.570346F;
    const float v228 = v225 + v227;
    const float v230 = state->obs[20] * 0.043355696F;
    const float v231 = v228 + v230;
    const float v233 = state->obs[21] * (-1.7338103F);
    const float v234 = v231 + v233;
    const float v236 = state->obs[22] * (-0.52388465F);
    const float v237 = v234 + v236;
    const float v239 = state->obs[23] * 1.151409F;
    const float v240 = v237 + v239;
    const float v242 = v240 + (-2.5815685F);
    const float v244 = state->obs[0] * (-1.0676469F);
    const float v246 = state->obs[1] * (-1.2909809F);
    const float v247 = v244 + v246;
    const float v249 = state->obs[2] * (-0.8371953F);
    const float v250 = v247 + v249;
    const float v252 = state->obs[3] * (-2.8452365F);
    const float v253 = v250 + v252;
    const float v255 = state->obs[4] * 0.021685855F;
    const float v256 = v253 + v255;
    const float v258 = state->obs[5] * (-0.06468743F);
    const float v259 = v256 + v258;
    const float v261 = state->obs[6] * (-0.13105504F);
    const float v262 = v259 + v261;
    const float v264 = state->obs[7] * 0.0043608746F;
    const float v265 = v262 + v264;
    const float v267 = state->obs[8] * (-0.018771987F);
    const float v268 = v265 + v267;
    const float v270 = state->obs[9] * 0.17987023F;
    const float v271 = v268 + v270;
    const float v273 = state->obs[10] * (-0.24441965F);
    const float v274 = v271 + v273;
    const float v276 = state->obs[11] * (-1.5290816F);
    const float v277 = v274 + v276;
    const float v279 = state->obs[12] * (-0.3734259F);
    const float v280 = v277 + v279;
    const float v282 = state->obs[13] * (-0.023268756F);
    const float v283 = v280 + v282;
    const float v285 = state->obs[14] * 0.32405788F;
    const float v286 = v283 + v285;
    const float v288 = state->obs[15] * 5.7792134F;
    const float v289 = v286 + v288;
    const float v291 = state->obs[16] * (-7.545338F);
    const float v292 = v289 + v291;
    const float v294 = state->obs[17] * 1.5639713F;
    const float v295 = v292 + v294;
    const float v297 = state->obs[18] * (-4.1553626F);
    const float v298 = v295 + v297;
    const float v300 = state->obs[19] * 4.670011F;
    const float v301 = v298 + v300;
    const float v303 = state->obs[20] * (-5.031331F);
    const float v304 = v301 + v303;
    const float v306 = state->obs[21] * 2.1768126F;
    const float v307 = v304 + v306;
    const float v309 = state->obs[22] * (-0.6732741F);
    const float v310 = v307 + v309;
    const float v312 = state->obs[23] * (-8.497251F);
    const float v313 = v310 + v312;
    const float v315 = v313 + 9.79428F;

    action->action_0 = bipedal_walker_clamp(v96, -1.0F, 1.0F, 0.0F);
    action->action_1 = bipedal_walker_clamp(v169, -1.0F, 1.0F, 0.0F);
    action->action_2 = bipedal_walker_clamp(v242, -1.0F, 1.0F, 0.0F);
    action->action_3 = bipedal_walker_clamp(v315, -1.0F, 1.0F, 0.0F);
}
#ifndef BIPEDAL_WALKER_NO_SELFTEST

uint32_t bipedal_walker_selftest(void)
{
    static const bipedal_walker_state_t states[16] = {
        { { -0.61270064F, -4.1961627F, 0.9656018F, -2.806754F, -1.3591121F, 2.1061022F, -0.24449022F, -3.473473F, 4.373905F, 1.2982574F, -0.16742843F, 0.48511934F, -4.005405F, 1.3195878F, -0.09308055F, -0.43954256F, 0.9820647F, 0.82470983F, 0.89423496F, -0.73351216F, -0.3126318F, -0.039395504F, -0.20533113F, -0.97260493F } },
        { { -2.8342214F, -3.1487048F, 0.2552497F, -2.3186753F, -2.5860555F, -3.995454F, 3.0851495F, 1.949953F, 0.5412273F, 0.50059414F, 2.307476F, 1.2858573F, -2.7657912F, 4.765683F, -0.7435385F, 0.26504543F, 0.60777766F, 0.16269131F, 0.7992153F, -0.24138537F, -0.046325635F, 0.84437793F, -0.32291302F, 0.25163704F } },
        { { -1.3714406F, -2.7317097F, 0.7186272F, 4.364328F, -0.9744423F, 4.0732274F, 3.1176965F, 3.893838F, 3.6621022F, 0.09567823F, 1.4992557F, 0.43110192F, 1.1433358F, 2.3601005F, 0.29675052F, 0.21315971F, -0.8697076F, -0.51887345F, -0.15897672F, -0.2682392F, -0.27462733F, -0.4909406F, 0.17897768F, -0.4494254F } },
        { { 2.4511247F, 1.5411043F, -2.8354604F, 1.2069616F, -0.86157006F, -2.466124F, 3.0378983F, 0.3900973F, 4.7022586F, -1.5387092F, -2.3123543F, -2.2765956F, -1.0283812F, 4.4015822F, 0.75981915F, -0.8658829F, 0.7264193F, 0.9164791F, 0.8547621F, -0.74921864F, -0.9235042F, -0.9441242F, 0.16845787F, 0.43762353F } },
        { { 1.7653059F, 4.6303506F, 2.4927826F, -3.988191F, 1.0273503F, -0.73719287F, -0.4066526F, 1.502973F, 4.0217214F, -2.9175165F, 3.0891476F, 0.055538185F, -4.781238F, 1.572776F, 0.5490373F, 0.96849376F, 0.6981805F, 0.2319354F, 0.0699479F, 0.010572243F, -0.19607791F, 0.72068024F, 0.6341236F, -0.13958214F } },
        { { -2.793035F, 0.52774197F, -1.2627038F, 4.895929F, -0.83998936F, -3.6492348F, -2.8978379F, -1.7748723F, 1.3313073F, -1.2806481F, 3.4071004F, 1.653386F, -2.6733515F, 4.229066F, 0.7212742F, -0.014962477F, 0.83785844F, 0.5269616F, 0.23487262F, 0.795179F, 0.56415206F, 0.9972262F, 0.17556827F, 0.24272469F } },
        { { 2.4162204F, 0.35968995F, 1.1264942F, 3.4930902F, 0.5192509F, -2.242748F, 0.4041656F, 2.7076447F, 3.6820545F, 1.7159363F, -1.5694419F, 0.8747585F, -3.7000523F, 3.305708F, 0.12169712F, 0.6141049F, -0.4407963F, -0.9244359F, -0.6230148F, 0.481095F, -0.8300251F, -0.1697307F, 0.6629426F, -0.07288496F } },
        { { -2.7151177F, -0.9575464F, -0.82091326F, -3.2837293F, -2.7234554F, -0.48369163F, 0.25783777F, 1.5545127F, 2.8985124F, 0.19925733F, 3.7707388F, -1.168804F, -4.7737584F, 2.9848323F, 0.25396022F, 0.65909237F, 0.534383F, -0.86459583F, 0.19725677F, -0.55941314F, -0.88276017F, -0.45854107F, -0.7655356F, 0.2292808F } },
        { { 1.4080184F, 0.27749264F, -0.5864996F, -3.6076758F, 0.10924223F, 4.6587114F, 0.022362826F, 0.7778371F, 4.9060473F, 1.3726511F, -4.557095F, -2.4067016F, -0.38034216F, 3.1688778F, -0.50404525F, 0.17340241F, 0.32819682F, 0.2700146F, 0.9842807F, -0.8341905F, -0.45775908F, 0.52310526F, -0.570292F, -0.12425124F } },
        { { 2.006955F, -4.919669F, 2.892338F, 4.179972F, -2.807373F, 2.219608F, -2.9275794F, 0.88509595F, 2.2281685F, 0.06488547F, -2.9792123F, -2.62693F, 3.302804F, 3.4880474F, -0.07994203F, 0.70640177F, -0.046376113F, -0.36199653F, 0.07755518F, 0.60127515F, -0.8052752F, 0.8311216F, -0.55537635F, -0.111174405F } },
        { { 1.062898F, -2.2445502F, -4.8181486F, -3.9133246F, -2.3391643F, 3.0064662F, 1.0053053F, 2.820142F, 3.9517746F, 2.7413507F, -1.0619955F, -0.5408547F, 4.2251883F, 1.9714065F, -0.23171756F, -0.5495546F, 0.64397174F, -0.3282702F, -0.29928052F, 0.7087638F, 0.9832665F, -0.19821428F, 0.21507715F, -0.109681435F } },
        { { -1.9739575F, -0.44704574F, 0.8037719F, -0.115534104F, -3.0569077F, 3.4067953F, -0.96807176F, 1.1534963F, 1.8425353F, 0.86192167F, 1.6609571F, -1.22454F, -1.477899F, 0.5018423F, -0.8597982F, -0.9264768F, 0.70828325F, 0.7875748F, -0.82244223F, 0.13873945F, -0.80483294F, -0.83390206F, 0.7014112F, -0.9812226F } },
        { { 3.0157595F, 3.4430091F, 1.6547275F, -2.396296F, -1.0794812F, -1.9431112F, -2.8803346F, 4.2433515F, 0.6662938F, -0.53628975F, -2.5864613F, 1.9085186F, 4.9894466F, 1.7246609F, -0.6106642F, -0.8431354F, -0.3177472F, 0.2120179F, -0.56849927F, -0.13488986F, 0.31576246F, -0.54719037F, -0.5632867F, 0.70680976F } },
        { { -1.45919F, -4.4896626F, 0.3950912F, -2.143361F, -3.0231905F, 0.88647926F, -1.9035056F, 0.3865883F, 4.490629F, 0.22050972F, -2.4494715F, 0.56919444F, 4.024625F, 4.802097F, -0.31512037F, -0.40973353F, -0.6149072F, 0.8266075F, 0.06671804F, -0.6763707F, 0.6202874F, -0.029286101F, 0.49496222F, 0.051917817F } },
        { { 2.2354515F, -0.6859805F, 2.342912F, -3.828083F, -1.5226966F, -4.5982094F, 3.0962331F, -2.0963333F, 0.47207174F, -1.142526F, -0.94666487F, 2.3512328F, -1.9567077F, 3.0688488F, -0.37233207F, -0.2572644F, -0.40281224F, -0.058706556F, -0.87242275F, -0.49026313F, 0.09168274F, 0.89540344F, -0.4842243F, -0.70013523F } },
        { { 1.7585518F, 1.1644782F, 1.4970539F, -2.9773874F, -0.67364F, -3.9374356F, 2.5674317F, 2.5247462F, 1.8996538F, 1.3151066F, 3.4999285F, -1.0690467F, 3.8178186F, 4.25727F, -0.89372796F, 0.9976013F, -0.6984599F, 0.38942474F, 0.79192054F, -0.5725889F, -0.31676745F, -0.84059F, -0.4114101F, 0.8242695F } },
    };
    static const bipedal_walker_action_t actions[16] = {
        { 1.0F, -1.0F, 1.0F, 1.0F },
        { -1.0F, -1.0F, -1.0F, 1.0F },
        { 1.0F, -1.0F, -1.0F, 1.0F },
        { 1.0F, -1.0F, -1.0F, -1.0F },
        { -1.0F, 1.0F, 1.0F, 1.0F },
        { 1.0F, -1.0F, -1.0F, -1.0F },
        { -1.0F, -1.0F, 1.0F, 1.0F },
        { -1.0F, 1.0F, -1.0F, 1.0F },
        { -1.0F, -1.0F, 0.22930717F, 1.0F },
        { -1.0F, -1.0F, 1.0F, 1.0F },
        { 1.0F, -1.0F, 1.0F, 1.0F },
        { 1.0F, -1.0F, -1.0F, 1.0F },
        { 1.0F, 1.0F, 1.0F, -1.0F },
        { 1.0F, -1.0F, -1.0F, 1.0F },
        { 1.0F, 0.34114838F, 1.0F, 1.0F },
        { -1.0F, -1.0F, -1.0F, 1.0F },
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        bipedal_walker_action_t action;

        bipedal_walker_infer(&states[vector], &action);
        if ((action.action_0 < actions[vector].action_0) || (action.action_0 > actions[vector].action_0) ||
            (action.action_1 < actions[vector].action_1) || (action.action_1 > actions[vector].action_1) ||
            (action.action_2 < actions[vector].action_2) || (action.action_2 > actions[vector].action_2) ||
            (action.action_3 < actions[vector].action_3) || (action.action_3 > actions[vector].action_3)) {
            failures++;
        }
    }
    return failures;
}
#endif
