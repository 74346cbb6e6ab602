/* JKR sphere f = r^2/(2R): folds and equilibria in SI units and in those of Maugis. The mdr developers, mdr: certified reference values of adhesive contact mechanics, release 4, table jkr-sphere. CC0-1.0: to be copied without conditions. */
#ifndef MDR_JKR_SPHERE_H
#define MDR_JKR_SPHERE_H

#include <math.h>

struct mdr_jkr_sphere {
    const char *id;
    const char *question;
    const char *control;
    const char *branch;
    double radius; /* m */
    double e_star; /* Pa */
    double work_of_adhesion; /* J/m^2 */
    const char *status;
    double contact_radius; /* m */
    double indentation; /* m */
    double force; /* N */
    double tolerance;
    double maugis_contact_radius;
    double maugis_indentation;
    double maugis_force;
    const char *note;
};

static const struct mdr_jkr_sphere mdr_jkr_sphere_rows[] = {
    {"critical/jkr-unit/force", "fold", "force", "", 1.0, 1.0, 1.0, "ok", 1.523236946344889, -0.773416931570034, -4.71238898038469, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "pull-off force -3/2 pi w R"},
    {"critical/jkr-unit/indentation", "fold", "indentation", "", 1.0, 1.0, 1.0, "ok", 0.7322959437807617, -1.6087720478332692, -2.6179938779914944, 9.3e-16, 0.550321208149, -0.908560296416, -0.833333333333, "force where fixed grips let go, -5/6 pi w R"},
    {"critical/afm-tip/force", "fold", "force", "", 2e-8, 70000000000.0, 0.1, "ok", 1.2640224346807618e-9, -2.662921192293801e-11, -9.42477796076938e-9, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "tip of an atomic force microscope"},
    {"critical/afm-tip/indentation", "fold", "indentation", "", 2e-8, 70000000000.0, 0.1, "ok", 6.07678604425751e-10, -5.539099294152424e-11, -5.235987755982989e-9, 9.3e-16, 0.550321208149, -0.908560296416, -0.833333333333, "tip of an atomic force microscope"},
    {"critical/gecko-spatula/force", "fold", "force", "", 1e-7, 2000000000.0, 0.05, "ok", 9.595791463387565e-9, -3.069307126960722e-10, -2.356194490192345e-8, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "adhesive pad"},
    {"critical/gecko-spatula/indentation", "fold", "indentation", "", 1e-7, 2000000000.0, 0.05, "ok", 4.613175371610071e-9, -6.384416102768915e-10, -1.3089969389957472e-8, 9.3e-16, 0.550321208149, -0.908560296416, -0.833333333333, "adhesive pad"},
    {"critical/pdms-bead/force", "fold", "force", "", 1e-5, 1300000.0, 0.05, "ok", 2.386581935584409e-6, -1.898591111752608e-7, -2.3561944901923448e-6, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "bead of silicone rubber"},
    {"critical/pdms-bead/indentation", "fold", "indentation", "", 1e-5, 1300000.0, 0.05, "ok", 1.1473489237000123e-6, -3.9492286581467296e-7, -1.3089969389957471e-6, 9.3e-16, 0.550321208149, -0.908560296416, -0.833333333333, "bead of silicone rubber"},
    {"critical/tyre-asperity/force", "fold", "force", "", 0.0001, 5000000.0, 0.06, "ok", 7.513250698284079e-6, -1.8816312018422067e-7, -2.827433388230814e-5, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "asperity of rubber"},
    {"critical/tyre-asperity/indentation", "fold", "indentation", "", 0.0001, 5000000.0, 0.06, "ok", 3.611994197070683e-6, -3.9139506239016863e-7, -1.5707963267948967e-5, 9.3e-16, 0.550321208149, -0.908560296416, -0.833333333333, "asperity of rubber"},
    {"critical/glass-bead/force", "fold", "force", "", 0.001, 40000000000.0, 0.08, "ok", 1.919158292677513e-6, -1.2277228507842889e-9, -0.0003769911184307752, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "bead of glass"},
    {"critical/glass-bead/indentation", "fold", "indentation", "", 0.001, 40000000000.0, 0.08, "ok", 9.226350743220142e-7, -2.553766441107566e-9, -0.00020943951023931956, 9.3e-16, 0.550321208149, -0.908560296416, -0.833333333333, "bead of glass"},
    {"critical/stiff-1e100/force", "fold", "force", "", 1.0, 1e100, 1.0, "ok", 7.070239601100864e-34, -1.6662762672324967e-67, -4.71238898038469, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "scale: an absolute tolerance finds a = 0"},
    {"critical/soft-1e-100/force", "fold", "force", "", 1.0, 1e-100, 1.0, "ok", 3.281714518343664e33, -3.5898833933025284e66, -4.71238898038469, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "scale: a starting value of order 1 is far off"},
    {"critical/sticky-1e100/force", "fold", "force", "", 1.0, 1.0, 1e100, "ok", 3.281714518343664e33, -3.5898833933025284e66, -4.71238898038469e100, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "scale: powers of w leave the doubles"},
    {"critical/slippery-1e-100/force", "fold", "force", "", 1.0, 1.0, 1e-100, "ok", 7.070239601100864e-34, -1.6662762672324967e-67, -4.71238898038469e-100, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "scale: w is below every absolute tolerance"},
    {"critical/sharp-1e100/force", "fold", "force", "", 5e-101, 1.0, 1.0, "ok", 2.0673506007033986e-67, -2.849292337485802e-34, -2.356194490192345e-100, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "scale: a small radius"},
    {"critical/flat-1e-100/force", "fold", "force", "", 5e99, 1.0, 1.0, "ok", 4.453971850613655e66, -1.322524349737255e33, -2.356194490192345e100, 9.3e-16, 1.14471424255, -0.436790232368, -1.5, "scale: a large radius"},
    {"equilibrium/jkr-unit/near=2^-3/outer/indentation", "equilibrium", "indentation", "stable", 1.0, 1.0, 1.0, "ok", 1.1110866774543389, -1.4076755418541107, -4.042533494430019, 2.2e-15, 0.834982861626, -0.794990259364, -1.28677837651, ""},
    {"equilibrium/jkr-unit/near=2^-3/inner/indentation", "equilibrium", "indentation", "unstable", 1.0, 1.0, 1.0, "ok", 0.38546331429348946, -1.4076755418541107, -1.123396491169517, 4.2e-15, 0.28967610516, -0.794990259364, -0.357588209243, "the other root at the same d"},
    {"equilibrium/jkr-unit/near=2^-3/outer/force", "equilibrium", "force", "stable", 1.0, 1.0, 1.0, "ok", 1.8638790452010037, 0.051897022485788195, -4.123340357836604, 8.7e-14, 1.40070715496, 0.0293090461115, -1.3125, ""},
    {"equilibrium/jkr-unit/near=2^-3/inner/force", "equilibrium", "force", "unstable", 1.0, 1.0, 1.0, "ok", 1.1388221520635724, -1.378047771766733, -4.123340357836604, 2.4e-15, 0.855826101337, -0.778257860508, -1.3125, "the other root at the same F"},
    {"equilibrium/jkr-unit/opposite/outer/indentation", "equilibrium", "indentation", "stable", 1.0, 1.0, 1.0, "ok", 2.3315815173649646, 1.6087720478332692, -0.9481084460317376, 6.6e-15, 1.75218607782, 0.908560296416, -0.301792291546, "pressed in, one root only: squared equations have two"},
    {"equilibrium/jkr-unit/opposite/outer/force", "equilibrium", "force", "stable", 1.0, 1.0, 1.0, "ok", 2.7412664779728195, 3.364375008123921, 4.71238898038469, 6.4e-16, 2.06006477686, 1.90004392403, 1.5, "pressed, one root only"},
    {"equilibrium/jkr-unit/opposite-1e6/outer/indentation", "equilibrium", "indentation", "stable", 1.0, 1.0, 1.0, "ok", 1268.4089721859227, 1608772.0478332692, 2720699043.209705, 1.4e-15, 953.210739359, 908560.296416, 866025402.784, "nearly the contact of Hertz"},
    {"equilibrium/jkr-unit/opposite-1e6/outer/force", "equilibrium", "force", "stable", 1.0, 1.0, 1.0, "ok", 152.4252776045424, 23202.518261616086, 4712388.98038469, 7.8e-16, 114.547763969, 13103.7127962, 1500000.0, "nearly the contact of Hertz"},
    {"equilibrium/jkr-unit/near=2^-12/outer/indentation", "equilibrium", "indentation", "stable", 1.0, 1.0, 1.0, "ok", 0.7485070763495374, -1.6083792812200286, -2.6873403488008103, 6.7e-14, 0.562503892126, -0.908338479937, -0.855407000564, "near the fold: see tolerance"},
    {"equilibrium/jkr-unit/near=2^-12/inner/indentation", "equilibrium", "indentation", "unstable", 1.0, 1.0, 1.0, "ok", 0.7161444108628952, -1.6083792812200286, -2.548519558976446, 6.8e-14, 0.538183313375, -0.908338479937, -0.811218970755, "near the fold: see tolerance"},
    {"equilibrium/jkr-unit/near=2^-26/outer/force", "equilibrium", "force", "stable", 1.0, 1.0, 1.0, "ok", 1.5233609051630188, -0.7731651554412506, -4.712388910164622, 1.5e-11, 1.14480739774, -0.436648040816, -1.49999997765, "very near the fold: see tolerance"},
    {"equilibrium/jkr-unit/near=2^-26/inner/force", "equilibrium", "force", "unstable", 1.0, 1.0, 1.0, "ok", 1.5231129824827592, -0.7736686820881276, -4.712388910164622, 1.5e-11, 1.14462108357, -0.436932409456, -1.49999997765, "very near the fold: see tolerance"},
    {"equilibrium/afm-tip/near=2^-3/outer/indentation", "equilibrium", "indentation", "stable", 2e-8, 70000000000.0, 0.1, "ok", 9.220092058213516e-10, -4.846711882383371e-11, -8.085066988860039e-9, 2.2e-15, 0.834982861626, -0.794990259364, -1.28677837651, "the same shares in SI units"},
    {"equilibrium/afm-tip/near=2^-3/inner/indentation", "equilibrium", "indentation", "unstable", 2e-8, 70000000000.0, 0.1, "ok", 3.198676858400291e-10, -4.846711882383371e-11, -2.2467929823390334e-9, 4.2e-15, 0.28967610516, -0.794990259364, -0.357588209243, "the other root at the same d"},
    {"equilibrium/afm-tip/near=2^-3/outer/force", "equilibrium", "force", "stable", 2e-8, 70000000000.0, 0.1, "ok", 1.5466962866931326e-9, 1.7868458182550043e-12, -8.246680715673207e-9, 8.7e-14, 1.40070715496, 0.0293090461115, -1.3125, "the same shares in SI units"},
    {"equilibrium/afm-tip/near=2^-3/inner/force", "equilibrium", "force", "unstable", 2e-8, 70000000000.0, 0.1, "ok", 9.450248385675992e-10, -4.744701681125006e-11, -8.246680715673207e-9, 2.4e-15, 0.855826101337, -0.778257860508, -1.3125, "the other root at the same F"},
    {"equilibrium/afm-tip/opposite/outer/indentation", "equilibrium", "indentation", "stable", 2e-8, 70000000000.0, 0.1, "ok", 1.934808207815774e-9, 5.539099294152424e-11, -1.896216892063475e-9, 6.6e-15, 1.75218607782, 0.908560296416, -0.301792291546, "pressed in"},
    {"equilibrium/afm-tip/opposite/outer/force", "equilibrium", "force", "stable", 2e-8, 70000000000.0, 0.1, "ok", 2.2747756584492766e-9, 1.1583746285163349e-10, 9.42477796076938e-9, 6.4e-16, 2.06006477686, 1.90004392403, 1.5, "pressed"},
    {"equilibrium/jkr-unit/past=2^-1/outer/indentation", "equilibrium", "indentation", "", 1.0, 1.0, 1.0, "no-equilibrium", NAN, -2.413158071749904, NAN, NAN, NAN, -1.36284044462, NAN, "past the fold: no equilibrium, not 0 or NaN"},
    {"equilibrium/jkr-unit/past=2^-1/outer/force", "equilibrium", "force", "", 1.0, 1.0, 1.0, "no-equilibrium", NAN, NAN, -7.0685834705770345, NAN, NAN, NAN, -2.25, "past the fold: no equilibrium, not 0 or NaN"},
    {"equilibrium/jkr-unit/past=2^-26/outer/indentation", "equilibrium", "indentation", "", 1.0, 1.0, 1.0, "no-equilibrium", NAN, -1.6087720718058407, NAN, NAN, NAN, -0.908560309955, NAN, "just past the fold"},
    {"equilibrium/jkr-unit/past=2^-26/outer/force", "equilibrium", "force", "", 1.0, 1.0, 1.0, "no-equilibrium", NAN, NAN, -4.712389050604758, NAN, NAN, NAN, -1.50000002235, "just past the fold"},
    {"equilibrium/afm-tip/past=2^-1/outer/indentation", "equilibrium", "indentation", "", 2e-8, 70000000000.0, 0.1, "no-equilibrium", NAN, -8.308648941228636e-11, NAN, NAN, NAN, -1.36284044462, NAN, "past the fold"},
    {"equilibrium/afm-tip/past=2^-1/outer/force", "equilibrium", "force", "", 2e-8, 70000000000.0, 0.1, "no-equilibrium", NAN, NAN, -1.413716694115407e-8, NAN, NAN, NAN, -2.25, "past the fold"},
    {"equilibrium/afm-tip/past=2^-12/outer/force", "equilibrium", "force", "", 2e-8, 70000000000.0, 0.1, "no-equilibrium", NAN, NAN, -9.427078931951209e-9, NAN, NAN, NAN, -1.50036621094, "just past the fold"},
};

#define MDR_JKR_SPHERE_ROWS 43

#endif
