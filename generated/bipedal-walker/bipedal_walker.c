/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix bipedal_walker --profile fast
 * Graph SHA-256: 9d8c42d624c3770a63b707f660b7746c1bc1c049e8b73961774134beff3c0e09
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 194 distinct operations.
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

/* An output in its range. */
static float bipedal_walker_clamp(float value, float low, float high, float nan)
{
    const float raised = (value < low) ? low : value;
    const float limited = (raised > high) ? high : raised;
    return (isnan(value) != 0) ? nan : limited;
}

void bipedal_walker_infer(const bipedal_walker_state_t *state, bipedal_walker_action_t *action)
{
    const float v3 = state->obs[0] * 0.5046787F;
    const float v4 = 0.0F + v3;
    const float v7 = state->obs[1] * 8.018429F;
    const float v8 = v4 + v7;
    const float v11 = state->obs[2] * 1.1309677F;
    const float v12 = v8 + v11;
    const float v15 = state->obs[3] * 1.3572947F;
    const float v16 = v12 + v15;
    const float v19 = state->obs[4] * (-1.4042757F);
    const float v20 = v16 + v19;
    const float v23 = state->obs[5] * (-0.20148475F);
    const float v24 = v20 + v23;
    const float v27 = state->obs[7] * (-0.15425919F);
    const float v28 = v24 + v27;
    const float v31 = state->obs[8] * 0.22009312F;
    const float v32 = v28 + v31;
    const float v35 = state->obs[9] * 0.7223859F;
    const float v36 = v32 + v35;
    const float v39 = state->obs[10] * 0.05046511F;
    const float v40 = v36 + v39;
    const float v43 = state->obs[11] * (-0.47640488F);
    const float v44 = v40 + v43;
    const float v47 = state->obs[12] * 0.33258402F;
    const float v48 = v44 + v47;
    const float v51 = state->obs[13] * (-0.14858565F);
    const float v52 = v48 + v51;
    const float v55 = state->obs[14] * 0.7674586F;
    const float v56 = v52 + v55;
    const float v59 = state->obs[15] * (-0.17519812F);
    const float v60 = v56 + v59;
    const float v63 = state->obs[16] * 1.8191909F;
    const float v64 = v60 + v63;
    const float v67 = state->obs[17] * 1.8449576F;
    const float v68 = v64 + v67;
    const float v71 = state->obs[18] * (-2.8432984F);
    const float v72 = v68 + v71;
    const float v75 = state->obs[19] * (-0.18586843F);
    const float v76 = v72 + v75;
    const float v79 = state->obs[20] * (-0.771481F);
    const float v80 = v76 + v79;
    const float v83 = state->obs[21] * 1.6962188F;
    const float v84 = v80 + v83;
    const float v87 = state->obs[22] * 1.1837615F;
    const float v88 = v84 + v87;
    const float v91 = state->obs[23] * (-6.4229074F);
    const float v92 = v88 + v91;
    const float v94 = v92 + 2.5260677F;
    const float v96 = state->obs[0] * 1.8828421F;
    const float v97 = 0.0F + v96;
    const float v99 = state->obs[1] * 8.03671F;
    const float v100 = v97 + v99;
    const float v102 = state->obs[2] * (-0.094880946F);
    const float v103 = v100 + v102;
    const float v105 = state->obs[3] * (-2.3845007F);
    const float v106 = v103 + v105;
    const float v108 = state->obs[4] * 0.6801684F;
    const float v109 = v106 + v108;
    const float v111 = state->obs[5] * (-0.04494099F);
    const float v112 = v109 + v111;
    const float v115 = state->obs[6] * (-0.5763401F);
    const float v116 = v112 + v115;
    const float v118 = state->obs[7] * (-0.1844264F);
    const float v119 = v116 + v118;
    const float v121 = state->obs[8] * (-0.035329953F);
    const float v122 = v119 + v121;
    const float v124 = state->obs[9] * 0.8470248F;
    const float v125 = v122 + v124;
    const float v127 = state->obs[10] * 0.13221936F;
    const float v128 = v125 + v127;
    const float v130 = state->obs[11] * 0.72477835F;
    const float v131 = v128 + v130;
    const float v133 = state->obs[12] * 0.15656033F;
    const float v134 = v131 + v133;
    const float v136 = state->obs[13] * 0.18303227F;
    const float v137 = v134 + v136;
    const float v139 = state->obs[14] * (-0.9859452F);
    const float v140 = v137 + v139;
    const float v142 = state->obs[15] * (-1.3015733F);
    const float v143 = v140 + v142;
    const float v145 = state->obs[16] * (-1.0328742F);
    const float v146 = v143 + v145;
    const float v148 = state->obs[17] * (-2.4927297F);
    const float v149 = v146 + v148;
    const float v151 = state->obs[18] * 1.37519F;
    const float v152 = v149 + v151;
    const float v154 = state->obs[19] * (-2.2172704F);
    const float v155 = v152 + v154;
    const float v157 = state->obs[20] * 1.180808F;
    const float v158 = v155 + v157;
    const float v160 = state->obs[21] * (-1.329915F);
    const float v161 = v158 + v160;
    const float v163 = state->obs[22] * (-0.25188348F);
    const float v164 = v161 + v163;
    const float v166 = state->obs[23] * 6.103324F;
    const float v167 = v164 + v166;
    const float v169 = v167 + (-2.4470737F);
    const float v171 = state->obs[0] * 1.0497155F;
    const float v172 = 0.0F + v171;
    const float v174 = state->obs[1] * 4.5926456F;
    const float v175 = v172 + v174;
    const float v177 = state->obs[2] * 1.7125864F;
    const float v178 = v175 + v177;
    const float v180 = state->obs[3] * (-1.2706293F);
    const float v181 = v178 + v180;
    const float v183 = state->obs[4] * 0.04261334F;
    const float v184 = v181 + v183;
    const float v186 = state->obs[5] * (-0.1246854F);
    const float v187 = v184 + v186;
    const float v189 = state->obs[6] * 0.022234725F;
    const float v190 = v187 + v189;
    const float v192 = state->obs[7] * 0.29823032F;
    const float v193 = v190 + v192;
    const float v195 = state->obs[8] * (-0.003917866F);
    const float v196 = v193 + v195;
    const float v198 = state->obs[9] * (-0.1538466F);
    const float v199 = v196 + v198;
    const float v201 = state->obs[10] * (-0.49762392F);
    const float v202 = v199 + v201;
    const float v204 = state->obs[11] * 0.19477585F;
    const float v205 = v202 + v204;
    const float v207 = state->obs[12] * (-0.017092187F);
    const float v208 = v205 + v207;
    const float v210 = state->obs[13] * (-0.31458244F);
    const float v211 = v208 + v210;
    const float v213 = state->obs[14] * 6.3393784F;
    const float v214 = v211 + v213;
    const float v216 = state->obs[15] * 2.131467F;
    const float v217 = v214 + v216;
    const float v219 = state->obs[16] * 1.6827623F;
    const float v220 = v217 + v219;
    const float v222 = state->obs[17] * (-2.958541F);
    const float v223 = v220 + v222;
    const float v225 = state->obs[18] * 2.4626467F;
    const float v226 = v223 + v225;
    const float v228 = state->obs[19] * 1.1390029F;
    const float v229 = v226 + v228;
    const float v231 = state->obs[20] * (-1.7571104F);
    const float v232 = v229 + v231;
    const float v234 = state->obs[21] * 1.0455837F;
    const float v235 = v232 + v234;
    const float v237 = state->obs[22] * 0.4267561F;
    const float v238 = v235 + v237;
    const float v240 = state->obs[23] * (-11.318814F);
    const float v241 = v238 + v240;
    const float v243 = v241 + 6.3224926F;
    const float v245 = state->obs[0] * 0.4515603F;
    const float v246 = 0.0F + v245;
    const float v248 = state->obs[1] * 14.720121F;
    const float v249 = v246 + v248;
    const float v251 = state->obs[2] * 0.44103858F;
    const float v252 = v249 + v251;
    const float v254 = state->obs[3] * (-1.2183368F);
    const float v255 = v252 + v254;
    const float v257 = state->obs[4] * (-0.250826F);
    const float v258 = v255 + v257;
    const float v260 = state->obs[5] * 0.49178404F;
    const float v261 = v258 + v260;
    const float v263 = state->obs[6] * (-0.3779984F);
    const float v264 = v261 + v263;
    const float v266 = state->obs[7] * (-0.0028148007F);
    const float v267 = v264 + v266;
    const float v269 = state->obs[8] * 0.06386011F;
    const float v270 = v267 + v269;
    const float v272 = state->obs[9] * (-0.041378263F);
    const float v273 = v270 + v272;
    const float v275 = state->obs[10] * (-0.19922008F);
    const float v276 = v273 + v275;
    const float v278 = state->obs[11] * (-1.1892239F);
    const float v279 = v276 + v278;
    const float v281 = state->obs[12] * (-0.49735847F);
    const float v282 = v279 + v281;
    const float v284 = state->obs[13] * 0.43485624F;
    const float v285 = v282 + v284;
    const float v287 = state->obs[14] * (-5.629588F);
    const float v288 = v285 + v287;
    const float v290 = state->obs[15] * 1.6327361F;
    const float v291 = v288 + v290;
    const float v293 = state->obs[16] * 3.8373559F;
    const float v294 = v291 + v293;
    const float v296 = state->obs[17] * (-0.42398152F);
    const float v297 = v294 + v296;
    const float v299 = state->obs[18] * (-2.8770363F);
    const float v300 = v297 + v299;
    const float v302 = state->obs[19] * (-0.4884606F);
    const float v303 = v300 + v302;
    const float v305 = state->obs[20] * (-2.4138744F);
    const float v306 = v303 + v305;
    const float v308 = state->obs[21] * (-0.7583262F);
    const float v309 = v306 + v308;
    const float v311 = state->obs[22] * 0.5175674F;
    const float v312 = v309 + v311;
    const float v314 = state->obs[23] * (-4.1500196F);
    const float v315 = v312 + v314;
    const float v317 = v315 + 6.9373F;

    action->action_0 = bipedal_walker_clamp(v94, -1.0F, 1.0F, 0.0F);
    action->action_1 = bipedal_walker_clamp(v169, -1.0F, 1.0F, 0.0F);
    action->action_2 = bipedal_walker_clamp(v243, -1.0F, 1.0F, 0.0F);
    action->action_3 = bipedal_walker_clamp(v317, -1.0F, 1.0F, 0.0F);
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
        { -1.0F, -1.0F, 0.3619566F, -1.0F },
        { -1.0F, -1.0F, -1.0F, -1.0F },
        { -1.0F, -1.0F, -1.0F, -1.0F },
        { 1.0F, 1.0F, 1.0F, 1.0F },
        { 1.0F, 1.0F, 1.0F, 1.0F },
        { 1.0F, -1.0F, -1.0F, 1.0F },
        { 1.0F, -1.0F, 1.0F, 1.0F },
        { -1.0F, -1.0F, 1.0F, 1.0F },
        { 0.47815847F, 1.0F, 1.0F, 1.0F },
        { -1.0F, -1.0F, -1.0F, -1.0F },
        { -1.0F, -1.0F, -1.0F, -1.0F },
        { 1.0F, -1.0F, 1.0F, 1.0F },
        { 1.0F, 1.0F, 1.0F, 1.0F },
        { -1.0F, -1.0F, -1.0F, -1.0F },
        { 1.0F, -0.30444503F, 1.0F, 1.0F },
        { 1.0F, 1.0F, 1.0F, 1.0F },
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
