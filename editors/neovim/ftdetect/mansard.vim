autocmd BufNewFile,BufRead *.style setfiletype mansard
