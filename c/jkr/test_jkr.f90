! SPDX-License-Identifier: MIT
! Checks of jkr.f90: JKR's pull-off force and depth, a history, and the statuses. The numbers themselves are checked in C.
program test_jkr
    use jkr
    use, intrinsic :: iso_c_binding, only: c_double
    implicit none
    real(c_double), parameter :: pi = 3.14159265358979323846_c_double, radius = 1e-6_c_double, modulus = 1e9_c_double, &
                                 work = 0.05_c_double
    type(jkr_contact) :: contact, receding
    type(jkr_fast) :: fast, fast_receding
    type(jkr_state) :: state, quick
    real(c_double) :: depth
    integer :: failed = 0

    call check(jkr_set(contact, radius, modulus, work) == JKR_OK, 'set')
    call check(jkr_set(receding, radius, modulus, 3 * work) == JKR_OK, 'set')
    call check(jkr_fast_set(fast, contact) == JKR_OK, 'fast_set')
    call check(jkr_fast_set(fast_receding, receding) == JKR_OK, 'fast_set')

    call check(jkr_fold(contact, JKR_FORCE, state) == JKR_FOLD_REACHED, 'fold')
    call check(near(state%force, -1.5_c_double * pi * work * radius), 'pull-off force')
    call check(jkr_fold(contact, JKR_INDENTATION, state) == JKR_FOLD_REACHED, 'fold at fixed grips')
    depth = state%indentation
    call check(near(state%force, -pi * work * radius * 5 / 6), 'force at fixed grips')
    call check(jkr_at_indentation(contact, 1.001_c_double * depth, JKR_STABLE, state) == JKR_NO_EQUILIBRIUM, 'beyond the fold')

    call check(jkr_at_indentation(contact, 0.9_c_double * depth, JKR_STABLE, state) == JKR_OK, 'at_indentation')
    call check(jkr_fast_at_indentation(fast, 0.9_c_double * depth, JKR_STABLE, quick) == JKR_OK, 'fast_at_indentation')
    call check(near(quick%contact_radius, state%contact_radius) .and. near(quick%force, state%force), 'the two agree')
    call check(jkr_at_force(contact, state%force, JKR_UNSTABLE, quick) == JKR_OK, 'at_force')
    call check(near(quick%contact_radius, state%contact_radius), 'there and back')
    call check(jkr_at_contact_radius(contact, state%contact_radius, quick) == JKR_OK, 'at_contact_radius')
    call check(near(quick%force, state%force), 'force at a contact radius')
    call check(jkr_fast_at_contact_radius(fast, state%contact_radius, quick) == JKR_OK, 'fast_at_contact_radius')
    call check(near(quick%force, state%force), 'fast force at a contact radius')
    call check(jkr_fast_at_force(fast, 1e-7_c_double, JKR_STABLE, quick) == JKR_OK, 'fast_at_force')

    ! Touch, draw back a little: the edge is pinned, and the slope that of a flat punch.
    call check(jkr_follow(contact, receding, 0.0_c_double, 0.0_c_double, state) == JKR_OK, 'touch')
    depth = state%contact_radius
    call check(jkr_follow(contact, receding, depth, -1e-12_c_double, state) == JKR_OK, 'pinned')
    call check(near(state%contact_radius, depth) .and. near(state%stiffness, 2 * modulus * depth), 'flat punch')
    call check(jkr_fast_follow(fast, fast_receding, depth, -1e-12_c_double, quick) == JKR_OK, 'fast_follow')
    call check(near(quick%force, state%force), 'fast history')
    call check(jkr_follow(contact, receding, depth, -1e-6_c_double, state) == JKR_DETACHED, 'detached')

    if (failed /= 0) error stop 1
    print '(a)', 'Fortran: all checks hold'

contains

    logical function near(x, y)
        real(c_double), intent(in) :: x, y
        near = abs(x - y) <= 16 * epsilon(x) * abs(y)
    end function

    subroutine check(holds, what)
        logical, intent(in) :: holds
        character(*), intent(in) :: what
        if (holds) return
        failed = failed + 1
        print '(2a)', 'fails: ', what
    end subroutine
end program
