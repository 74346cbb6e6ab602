! The same from Fortran 2003.
!
!     gfortran states.f90 -L../../../target/capi/lib -lmdr -o states && ./states
program states
    use, intrinsic :: iso_c_binding
    implicit none

    interface
        type(c_ptr) function mdr_scene_read(text) bind(c)
            import :: c_ptr, c_char
            character(kind=c_char), intent(in) :: text(*)
        end function
        subroutine mdr_scene_free(scene) bind(c)
            import :: c_ptr
            type(c_ptr), value :: scene
        end subroutine
        type(c_ptr) function mdr_contact_new(scene) bind(c)
            import :: c_ptr
            type(c_ptr), value :: scene
        end function
        subroutine mdr_contact_free(contact) bind(c)
            import :: c_ptr
            type(c_ptr), value :: contact
        end subroutine
        integer(c_int) function mdr_states(contact, control, stiffness, choice, values, count, contact_radius, indentation, &
                                           force, status) bind(c)
            import :: c_ptr, c_int, c_double, c_size_t
            type(c_ptr), value :: contact
            integer(c_int), value :: control, choice
            real(c_double), value :: stiffness
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: values(*)
            real(c_double), intent(out) :: contact_radius(*), indentation(*), force(*)
            integer(c_int), intent(out) :: status(*)
        end function
    end interface

    integer(c_int), parameter :: by_force = 1, largest = 0
    character(*), parameter :: newline = achar(10)
    real(c_double), parameter :: forces(3) = [1e-6_c_double, 0.0_c_double, -3e-6_c_double]
    real(c_double) :: a(3), d(3), f(3)
    integer(c_int) :: status(3)
    type(c_ptr) :: scene, contact

    scene = mdr_scene_read('[profile]' // newline // 'kind = "paraboloid"' // newline // 'radius = 1e-5' // newline &
                           // '[material]' // newline // 'e_star = 1.3e6' // newline // 'work_of_adhesion = 0.05' // newline &
                           // '[control]' // newline // 'kind = "force"' // newline &
                           // '[output]' // newline // 'want = ["folds"]' // newline // c_null_char)
    if (.not. c_associated(scene)) error stop 'no scene'
    contact = mdr_contact_new(scene)
    call mdr_scene_free(scene)
    if (mdr_states(contact, by_force, 0.0_c_double, largest, forces, 3_c_size_t, a, d, f, status) /= 0) error stop 'no states'
    call mdr_contact_free(contact)
    print '(3es16.8)', a
    if (any(status /= [0, 0, 2])) error stop 'statuses'
end program
