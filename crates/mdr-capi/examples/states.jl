# The same from Julia: julia states.jl ../../../target/capi/lib/libmdr.so
const libmdr = get(ARGS, 1, "libmdr")

scene = ccall((:mdr_scene_read, libmdr), Ptr{Cvoid}, (Cstring,), """
    [profile]
    kind = "paraboloid"
    radius = 1e-5
    [material]
    e_star = 1.3e6
    work_of_adhesion = 0.05
    [control]
    kind = "force"
    [output]
    want = ["folds"]
    """)
scene == C_NULL && error(unsafe_string(ccall((:mdr_error, libmdr), Cstring, ())))
contact = ccall((:mdr_contact_new, libmdr), Ptr{Cvoid}, (Ptr{Cvoid},), scene)
ccall((:mdr_scene_free, libmdr), Cvoid, (Ptr{Cvoid},), scene)

const FORCE, LARGEST = 1, 0
forces = [1e-6, 0.0, -3e-6]
a, d, F, status = similar(forces), similar(forces), similar(forces), zeros(Cint, 3)
done = ccall((:mdr_states, libmdr), Cint,
             (Ptr{Cvoid}, Cint, Cdouble, Cint, Ptr{Cdouble}, Csize_t, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Cint}),
             contact, FORCE, 0.0, LARGEST, forces, 3, a, d, F, status)
done == 0 || error(unsafe_string(ccall((:mdr_error, libmdr), Cstring, ())))
ccall((:mdr_contact_free, libmdr), Cvoid, (Ptr{Cvoid},), contact)
println(a)
@assert status == [0, 0, 2]
