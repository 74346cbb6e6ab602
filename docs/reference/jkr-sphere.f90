! JKR sphere f = r^2/(2R): folds and equilibria in SI units and in those of Maugis. The mdr developers, mdr: certified
! reference values of adhesive contact mechanics, release 4, table jkr-sphere. CC0-1.0: to be copied without conditions.
module mdr_jkr_sphere
  use, intrinsic :: iso_fortran_env, only: int64, real64
  implicit none
  private

  integer, parameter, public :: rows = 43
  ! NaN, where there is no number: x /= x
  real(real64), parameter :: nan = &
    transfer(9221120237041090560_int64, 1.0_real64)
  character(len=51), parameter, public :: id(rows) = [ &
    'critical/jkr-unit/force                            ', &
    'critical/jkr-unit/indentation                      ', &
    'critical/afm-tip/force                             ', &
    'critical/afm-tip/indentation                       ', &
    'critical/gecko-spatula/force                       ', &
    'critical/gecko-spatula/indentation                 ', &
    'critical/pdms-bead/force                           ', &
    'critical/pdms-bead/indentation                     ', &
    'critical/tyre-asperity/force                       ', &
    'critical/tyre-asperity/indentation                 ', &
    'critical/glass-bead/force                          ', &
    'critical/glass-bead/indentation                    ', &
    'critical/stiff-1e100/force                         ', &
    'critical/soft-1e-100/force                         ', &
    'critical/sticky-1e100/force                        ', &
    'critical/slippery-1e-100/force                     ', &
    'critical/sharp-1e100/force                         ', &
    'critical/flat-1e-100/force                         ', &
    'equilibrium/jkr-unit/near=2^-3/outer/indentation   ', &
    'equilibrium/jkr-unit/near=2^-3/inner/indentation   ', &
    'equilibrium/jkr-unit/near=2^-3/outer/force         ', &
    'equilibrium/jkr-unit/near=2^-3/inner/force         ', &
    'equilibrium/jkr-unit/opposite/outer/indentation    ', &
    'equilibrium/jkr-unit/opposite/outer/force          ', &
    'equilibrium/jkr-unit/opposite-1e6/outer/indentation', &
    'equilibrium/jkr-unit/opposite-1e6/outer/force      ', &
    'equilibrium/jkr-unit/near=2^-12/outer/indentation  ', &
    'equilibrium/jkr-unit/near=2^-12/inner/indentation  ', &
    'equilibrium/jkr-unit/near=2^-26/outer/force        ', &
    'equilibrium/jkr-unit/near=2^-26/inner/force        ', &
    'equilibrium/afm-tip/near=2^-3/outer/indentation    ', &
    'equilibrium/afm-tip/near=2^-3/inner/indentation    ', &
    'equilibrium/afm-tip/near=2^-3/outer/force          ', &
    'equilibrium/afm-tip/near=2^-3/inner/force          ', &
    'equilibrium/afm-tip/opposite/outer/indentation     ', &
    'equilibrium/afm-tip/opposite/outer/force           ', &
    'equilibrium/jkr-unit/past=2^-1/outer/indentation   ', &
    'equilibrium/jkr-unit/past=2^-1/outer/force         ', &
    'equilibrium/jkr-unit/past=2^-26/outer/indentation  ', &
    'equilibrium/jkr-unit/past=2^-26/outer/force        ', &
    'equilibrium/afm-tip/past=2^-1/outer/indentation    ', &
    'equilibrium/afm-tip/past=2^-1/outer/force          ', &
    'equilibrium/afm-tip/past=2^-12/outer/force         ']
  character(len=11), parameter, public :: question(rows) = [ &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'fold       ', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium', &
    'equilibrium']
  character(len=11), parameter, public :: control(rows) = [ &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'force      ', &
    'force      ', &
    'force      ', &
    'force      ', &
    'force      ', &
    'indentation', &
    'indentation', &
    'force      ', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'indentation', &
    'force      ', &
    'force      ', &
    'indentation', &
    'indentation', &
    'force      ', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'indentation', &
    'force      ', &
    'force      ']
  character(len=8), parameter, public :: branch(rows) = [ &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    'stable  ', &
    'unstable', &
    'stable  ', &
    'unstable', &
    'stable  ', &
    'stable  ', &
    'stable  ', &
    'stable  ', &
    'stable  ', &
    'unstable', &
    'stable  ', &
    'unstable', &
    'stable  ', &
    'unstable', &
    'stable  ', &
    'unstable', &
    'stable  ', &
    'stable  ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ', &
    '        ']
  real(real64), parameter, public :: radius(rows) = [ & ! m
    1.0_real64, &
    1.0_real64, &
    2e-8_real64, &
    2e-8_real64, &
    1e-7_real64, &
    1e-7_real64, &
    1e-5_real64, &
    1e-5_real64, &
    0.0001_real64, &
    0.0001_real64, &
    0.001_real64, &
    0.001_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    5e-101_real64, &
    5e99_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    2e-8_real64, &
    2e-8_real64, &
    2e-8_real64, &
    2e-8_real64, &
    2e-8_real64, &
    2e-8_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    2e-8_real64, &
    2e-8_real64, &
    2e-8_real64]
  real(real64), parameter, public :: e_star(rows) = [ & ! Pa
    1.0_real64, &
    1.0_real64, &
    70000000000.0_real64, &
    70000000000.0_real64, &
    2000000000.0_real64, &
    2000000000.0_real64, &
    1300000.0_real64, &
    1300000.0_real64, &
    5000000.0_real64, &
    5000000.0_real64, &
    40000000000.0_real64, &
    40000000000.0_real64, &
    1e100_real64, &
    1e-100_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    70000000000.0_real64, &
    70000000000.0_real64, &
    70000000000.0_real64, &
    70000000000.0_real64, &
    70000000000.0_real64, &
    70000000000.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    70000000000.0_real64, &
    70000000000.0_real64, &
    70000000000.0_real64]
  real(real64), parameter, public :: work_of_adhesion(rows) = [ & ! J/m^2
    1.0_real64, &
    1.0_real64, &
    0.1_real64, &
    0.1_real64, &
    0.05_real64, &
    0.05_real64, &
    0.05_real64, &
    0.05_real64, &
    0.06_real64, &
    0.06_real64, &
    0.08_real64, &
    0.08_real64, &
    1.0_real64, &
    1.0_real64, &
    1e100_real64, &
    1e-100_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    0.1_real64, &
    0.1_real64, &
    0.1_real64, &
    0.1_real64, &
    0.1_real64, &
    0.1_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    1.0_real64, &
    0.1_real64, &
    0.1_real64, &
    0.1_real64]
  character(len=14), parameter, public :: status(rows) = [ &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'ok            ', &
    'no-equilibrium', &
    'no-equilibrium', &
    'no-equilibrium', &
    'no-equilibrium', &
    'no-equilibrium', &
    'no-equilibrium', &
    'no-equilibrium']
  real(real64), parameter, public :: contact_radius(rows) = [ & ! m
    1.523236946344889_real64, &
    0.7322959437807617_real64, &
    1.2640224346807618e-9_real64, &
    6.07678604425751e-10_real64, &
    9.595791463387565e-9_real64, &
    4.613175371610071e-9_real64, &
    2.386581935584409e-6_real64, &
    1.1473489237000123e-6_real64, &
    7.513250698284079e-6_real64, &
    3.611994197070683e-6_real64, &
    1.919158292677513e-6_real64, &
    9.226350743220142e-7_real64, &
    7.070239601100864e-34_real64, &
    3.281714518343664e33_real64, &
    3.281714518343664e33_real64, &
    7.070239601100864e-34_real64, &
    2.0673506007033986e-67_real64, &
    4.453971850613655e66_real64, &
    1.1110866774543389_real64, &
    0.38546331429348946_real64, &
    1.8638790452010037_real64, &
    1.1388221520635724_real64, &
    2.3315815173649646_real64, &
    2.7412664779728195_real64, &
    1268.4089721859227_real64, &
    152.4252776045424_real64, &
    0.7485070763495374_real64, &
    0.7161444108628952_real64, &
    1.5233609051630188_real64, &
    1.5231129824827592_real64, &
    9.220092058213516e-10_real64, &
    3.198676858400291e-10_real64, &
    1.5466962866931326e-9_real64, &
    9.450248385675992e-10_real64, &
    1.934808207815774e-9_real64, &
    2.2747756584492766e-9_real64, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan]
  real(real64), parameter, public :: indentation(rows) = [ & ! m
    -0.773416931570034_real64, &
    -1.6087720478332692_real64, &
    -2.662921192293801e-11_real64, &
    -5.539099294152424e-11_real64, &
    -3.069307126960722e-10_real64, &
    -6.384416102768915e-10_real64, &
    -1.898591111752608e-7_real64, &
    -3.9492286581467296e-7_real64, &
    -1.8816312018422067e-7_real64, &
    -3.9139506239016863e-7_real64, &
    -1.2277228507842889e-9_real64, &
    -2.553766441107566e-9_real64, &
    -1.6662762672324967e-67_real64, &
    -3.5898833933025284e66_real64, &
    -3.5898833933025284e66_real64, &
    -1.6662762672324967e-67_real64, &
    -2.849292337485802e-34_real64, &
    -1.322524349737255e33_real64, &
    -1.4076755418541107_real64, &
    -1.4076755418541107_real64, &
    0.051897022485788195_real64, &
    -1.378047771766733_real64, &
    1.6087720478332692_real64, &
    3.364375008123921_real64, &
    1608772.0478332692_real64, &
    23202.518261616086_real64, &
    -1.6083792812200286_real64, &
    -1.6083792812200286_real64, &
    -0.7731651554412506_real64, &
    -0.7736686820881276_real64, &
    -4.846711882383371e-11_real64, &
    -4.846711882383371e-11_real64, &
    1.7868458182550043e-12_real64, &
    -4.744701681125006e-11_real64, &
    5.539099294152424e-11_real64, &
    1.1583746285163349e-10_real64, &
    -2.413158071749904_real64, &
    nan, &
    -1.6087720718058407_real64, &
    nan, &
    -8.308648941228636e-11_real64, &
    nan, &
    nan]
  real(real64), parameter, public :: force(rows) = [ & ! N
    -4.71238898038469_real64, &
    -2.6179938779914944_real64, &
    -9.42477796076938e-9_real64, &
    -5.235987755982989e-9_real64, &
    -2.356194490192345e-8_real64, &
    -1.3089969389957472e-8_real64, &
    -2.3561944901923448e-6_real64, &
    -1.3089969389957471e-6_real64, &
    -2.827433388230814e-5_real64, &
    -1.5707963267948967e-5_real64, &
    -0.0003769911184307752_real64, &
    -0.00020943951023931956_real64, &
    -4.71238898038469_real64, &
    -4.71238898038469_real64, &
    -4.71238898038469e100_real64, &
    -4.71238898038469e-100_real64, &
    -2.356194490192345e-100_real64, &
    -2.356194490192345e100_real64, &
    -4.042533494430019_real64, &
    -1.123396491169517_real64, &
    -4.123340357836604_real64, &
    -4.123340357836604_real64, &
    -0.9481084460317376_real64, &
    4.71238898038469_real64, &
    2720699043.209705_real64, &
    4712388.98038469_real64, &
    -2.6873403488008103_real64, &
    -2.548519558976446_real64, &
    -4.712388910164622_real64, &
    -4.712388910164622_real64, &
    -8.085066988860039e-9_real64, &
    -2.2467929823390334e-9_real64, &
    -8.246680715673207e-9_real64, &
    -8.246680715673207e-9_real64, &
    -1.896216892063475e-9_real64, &
    9.42477796076938e-9_real64, &
    nan, &
    -7.0685834705770345_real64, &
    nan, &
    -4.712389050604758_real64, &
    nan, &
    -1.413716694115407e-8_real64, &
    -9.427078931951209e-9_real64]
  real(real64), parameter, public :: tolerance(rows) = [ &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    9.3e-16_real64, &
    2.2e-15_real64, &
    4.2e-15_real64, &
    8.7e-14_real64, &
    2.4e-15_real64, &
    6.6e-15_real64, &
    6.4e-16_real64, &
    1.4e-15_real64, &
    7.8e-16_real64, &
    6.7e-14_real64, &
    6.8e-14_real64, &
    1.5e-11_real64, &
    1.5e-11_real64, &
    2.2e-15_real64, &
    4.2e-15_real64, &
    8.7e-14_real64, &
    2.4e-15_real64, &
    6.6e-15_real64, &
    6.4e-16_real64, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan]
  real(real64), parameter, public :: maugis_contact_radius(rows) = [ &
    1.14471424255_real64, &
    0.550321208149_real64, &
    1.14471424255_real64, &
    0.550321208149_real64, &
    1.14471424255_real64, &
    0.550321208149_real64, &
    1.14471424255_real64, &
    0.550321208149_real64, &
    1.14471424255_real64, &
    0.550321208149_real64, &
    1.14471424255_real64, &
    0.550321208149_real64, &
    1.14471424255_real64, &
    1.14471424255_real64, &
    1.14471424255_real64, &
    1.14471424255_real64, &
    1.14471424255_real64, &
    1.14471424255_real64, &
    0.834982861626_real64, &
    0.28967610516_real64, &
    1.40070715496_real64, &
    0.855826101337_real64, &
    1.75218607782_real64, &
    2.06006477686_real64, &
    953.210739359_real64, &
    114.547763969_real64, &
    0.562503892126_real64, &
    0.538183313375_real64, &
    1.14480739774_real64, &
    1.14462108357_real64, &
    0.834982861626_real64, &
    0.28967610516_real64, &
    1.40070715496_real64, &
    0.855826101337_real64, &
    1.75218607782_real64, &
    2.06006477686_real64, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan, &
    nan]
  real(real64), parameter, public :: maugis_indentation(rows) = [ &
    -0.436790232368_real64, &
    -0.908560296416_real64, &
    -0.436790232368_real64, &
    -0.908560296416_real64, &
    -0.436790232368_real64, &
    -0.908560296416_real64, &
    -0.436790232368_real64, &
    -0.908560296416_real64, &
    -0.436790232368_real64, &
    -0.908560296416_real64, &
    -0.436790232368_real64, &
    -0.908560296416_real64, &
    -0.436790232368_real64, &
    -0.436790232368_real64, &
    -0.436790232368_real64, &
    -0.436790232368_real64, &
    -0.436790232368_real64, &
    -0.436790232368_real64, &
    -0.794990259364_real64, &
    -0.794990259364_real64, &
    0.0293090461115_real64, &
    -0.778257860508_real64, &
    0.908560296416_real64, &
    1.90004392403_real64, &
    908560.296416_real64, &
    13103.7127962_real64, &
    -0.908338479937_real64, &
    -0.908338479937_real64, &
    -0.436648040816_real64, &
    -0.436932409456_real64, &
    -0.794990259364_real64, &
    -0.794990259364_real64, &
    0.0293090461115_real64, &
    -0.778257860508_real64, &
    0.908560296416_real64, &
    1.90004392403_real64, &
    -1.36284044462_real64, &
    nan, &
    -0.908560309955_real64, &
    nan, &
    -1.36284044462_real64, &
    nan, &
    nan]
  real(real64), parameter, public :: maugis_force(rows) = [ &
    -1.5_real64, &
    -0.833333333333_real64, &
    -1.5_real64, &
    -0.833333333333_real64, &
    -1.5_real64, &
    -0.833333333333_real64, &
    -1.5_real64, &
    -0.833333333333_real64, &
    -1.5_real64, &
    -0.833333333333_real64, &
    -1.5_real64, &
    -0.833333333333_real64, &
    -1.5_real64, &
    -1.5_real64, &
    -1.5_real64, &
    -1.5_real64, &
    -1.5_real64, &
    -1.5_real64, &
    -1.28677837651_real64, &
    -0.357588209243_real64, &
    -1.3125_real64, &
    -1.3125_real64, &
    -0.301792291546_real64, &
    1.5_real64, &
    866025402.784_real64, &
    1500000.0_real64, &
    -0.855407000564_real64, &
    -0.811218970755_real64, &
    -1.49999997765_real64, &
    -1.49999997765_real64, &
    -1.28677837651_real64, &
    -0.357588209243_real64, &
    -1.3125_real64, &
    -1.3125_real64, &
    -0.301792291546_real64, &
    1.5_real64, &
    nan, &
    -2.25_real64, &
    nan, &
    -1.50000002235_real64, &
    nan, &
    -2.25_real64, &
    -1.50036621094_real64]
  character(len=53), parameter, public :: note(rows) = [ &
    'pull-off force -3/2 pi w R                           ', &
    'force where fixed grips let go, -5/6 pi w R          ', &
    'tip of an atomic force microscope                    ', &
    'tip of an atomic force microscope                    ', &
    'adhesive pad                                         ', &
    'adhesive pad                                         ', &
    'bead of silicone rubber                              ', &
    'bead of silicone rubber                              ', &
    'asperity of rubber                                   ', &
    'asperity of rubber                                   ', &
    'bead of glass                                        ', &
    'bead of glass                                        ', &
    'scale: an absolute tolerance finds a = 0             ', &
    'scale: a starting value of order 1 is far off        ', &
    'scale: powers of w leave the doubles                 ', &
    'scale: w is below every absolute tolerance           ', &
    'scale: a small radius                                ', &
    'scale: a large radius                                ', &
    '                                                     ', &
    'the other root at the same d                         ', &
    '                                                     ', &
    'the other root at the same F                         ', &
    'pressed in, one root only: squared equations have two', &
    'pressed, one root only                               ', &
    'nearly the contact of Hertz                          ', &
    'nearly the contact of Hertz                          ', &
    'near the fold: see tolerance                         ', &
    'near the fold: see tolerance                         ', &
    'very near the fold: see tolerance                    ', &
    'very near the fold: see tolerance                    ', &
    'the same shares in SI units                          ', &
    'the other root at the same d                         ', &
    'the same shares in SI units                          ', &
    'the other root at the same F                         ', &
    'pressed in                                           ', &
    'pressed                                              ', &
    'past the fold: no equilibrium, not 0 or NaN          ', &
    'past the fold: no equilibrium, not 0 or NaN          ', &
    'just past the fold                                   ', &
    'just past the fold                                   ', &
    'past the fold                                        ', &
    'past the fold                                        ', &
    'just past the fold                                   ']
end module mdr_jkr_sphere
