# The page built from web/, as it is.
    .section .rodata
    .global porefines_page_begin
    .global porefines_page_end
porefines_page_begin:
    .incbin PF_PAGE
porefines_page_end:
    .byte 0
    .section .note.GNU-stack,"",@progbits
