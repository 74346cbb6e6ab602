! SPDX-License-Identifier: MIT
!
! jkr.h for Fortran 2003: compile jkr_fortran.c with a C compiler and link it.
!
!     use jkr
!     type(jkr_contact) :: contact
!     type(jkr_state) :: state
!     integer :: status
!     status = jkr_set(contact, radius, modulus, work)              ! R, E*, w
!     status = jkr_at_indentation(contact, d, JKR_STABLE, state)    ! state%contact_radius, state%force, state%stiffness
!
! Functions, statuses, units and errors are those of jkr.h. A contact that has been set may be copied and shared.
module jkr
    use, intrinsic :: iso_c_binding, only: c_int, c_double
    implicit none
    private

    ! Of jkr_status.
    integer(c_int), parameter, public :: JKR_OK = 0, JKR_FOLD_REACHED = 1, JKR_NO_EQUILIBRIUM = 2, JKR_DETACHED = 3
    integer(c_int), parameter, public :: JKR_OVERFLOW = 4, JKR_UNDERFLOW = 5, JKR_DOMAIN_ERROR = 6, JKR_INACCURATE = 7
    ! Branches.
    integer(c_int), parameter, public :: JKR_STABLE = 0, JKR_UNSTABLE = 1
    ! What is held.
    integer(c_int), parameter, public :: JKR_INDENTATION = 0, JKR_FORCE = 1

    ! A contact, as words of jkr_fortran.c.
    type, bind(c), public :: jkr_contact
        private
        real(c_double) :: words(64)
    end type

    ! A contact for the fast functions.
    type, bind(c), public :: jkr_fast
        private
        real(c_double) :: words(40)
    end type

    ! A state of equilibrium: a, d, F, dF/dd.
    type, bind(c), public :: jkr_state
        real(c_double) :: contact_radius = 0, indentation = 0, force = 0, stiffness = 0
    end type

    public :: jkr_set, jkr_at_contact_radius, jkr_at_indentation, jkr_at_force, jkr_fold, jkr_follow
    public :: jkr_fast_set, jkr_fast_at_contact_radius, jkr_fast_at_indentation, jkr_fast_at_force, jkr_fast_follow

    interface
        ! Sets a contact: R, E*, w.
        integer(c_int) function jkr_set(contact, radius, modulus, work) bind(c, name='jkr_f_set')
            import :: c_int, jkr_contact, c_double
            type(jkr_contact), intent(out) :: contact
            real(c_double), value :: radius, modulus, work
        end function

        ! The equilibrium with a contact radius.
        integer(c_int) function jkr_at_contact_radius(contact, radius, state) bind(c, name='jkr_f_at_contact_radius')
            import :: c_int, jkr_contact, c_double, jkr_state
            type(jkr_contact), intent(in) :: contact
            real(c_double), value :: radius
            type(jkr_state), intent(out) :: state
        end function

        ! The equilibrium at an indentation.
        integer(c_int) function jkr_at_indentation(contact, indentation, branch, state) bind(c, name='jkr_f_at_indentation')
            import :: c_int, jkr_contact, c_double, jkr_state
            type(jkr_contact), intent(in) :: contact
            real(c_double), value :: indentation
            integer(c_int), value :: branch
            type(jkr_state), intent(out) :: state
        end function

        ! The equilibrium at a force.
        integer(c_int) function jkr_at_force(contact, force, branch, state) bind(c, name='jkr_f_at_force')
            import :: c_int, jkr_contact, c_double, jkr_state
            type(jkr_contact), intent(in) :: contact
            real(c_double), value :: force
            integer(c_int), value :: branch
            type(jkr_state), intent(out) :: state
        end function

        ! The fold under a control, where the contact breaks.
        integer(c_int) function jkr_fold(contact, control, state) bind(c, name='jkr_f_fold')
            import :: c_int, jkr_contact, jkr_state
            type(jkr_contact), intent(in) :: contact
            integer(c_int), value :: control
            type(jkr_state), intent(out) :: state
        end function

        ! The next state of a history with two works of adhesion.
        integer(c_int) function jkr_follow(advancing, receding, radius, indentation, state) bind(c, name='jkr_f_follow')
            import :: c_int, jkr_contact, c_double, jkr_state
            type(jkr_contact), intent(in) :: advancing, receding
            real(c_double), value :: radius, indentation
            type(jkr_state), intent(out) :: state
        end function

        ! Sets a contact for the fast functions from one that is set.
        integer(c_int) function jkr_fast_set(fast, contact) bind(c, name='jkr_f_fast_set')
            import :: c_int, jkr_fast, jkr_contact
            type(jkr_fast), intent(out) :: fast
            type(jkr_contact), intent(in) :: contact
        end function

        ! The equilibrium with a contact radius in plain doubles.
        integer(c_int) function jkr_fast_at_contact_radius(fast, radius, state) bind(c, name='jkr_f_fast_at_contact_radius')
            import :: c_int, jkr_fast, c_double, jkr_state
            type(jkr_fast), intent(in) :: fast
            real(c_double), value :: radius
            type(jkr_state), intent(out) :: state
        end function

        ! The equilibrium at an indentation in plain doubles.
        integer(c_int) function jkr_fast_at_indentation(fast, indentation, branch, state) bind(c, name='jkr_f_fast_at_indentation')
            import :: c_int, jkr_fast, c_double, jkr_state
            type(jkr_fast), intent(in) :: fast
            real(c_double), value :: indentation
            integer(c_int), value :: branch
            type(jkr_state), intent(out) :: state
        end function

        ! The equilibrium at a force in plain doubles.
        integer(c_int) function jkr_fast_at_force(fast, force, branch, state) bind(c, name='jkr_f_fast_at_force')
            import :: c_int, jkr_fast, c_double, jkr_state
            type(jkr_fast), intent(in) :: fast
            real(c_double), value :: force
            integer(c_int), value :: branch
            type(jkr_state), intent(out) :: state
        end function

        ! The next state of a history with two works of adhesion in plain doubles.
        integer(c_int) function jkr_fast_follow(advancing, receding, radius, indentation, state) bind(c, name='jkr_f_fast_follow')
            import :: c_int, jkr_fast, c_double, jkr_state
            type(jkr_fast), intent(in) :: advancing, receding
            real(c_double), value :: radius, indentation
            type(jkr_state), intent(out) :: state
        end function
    end interface
end module
